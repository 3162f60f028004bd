// Computes the colours of an in-between frame as the weighted mean of the colours of points projected from the previous and the
// following frame.
//
// Based on the paper's interpolation: if points of both frames land on a pixel, its colour is the mean of their colours. If
// only one point does, the pixel gets its colour. Without a point, the pixel is missed (status -1). This implementation
// deviates in one point: the frame nearer in time has more weight (see in_between.cpp). Half way, which is the only case in the
// paper's recursion, the weights are equal.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "reuse/epipolar.hpp"
#include "reuse/motion.hpp"
#include "reuse/point_image.hpp"
#include "reuse/splat.hpp"

namespace lippmann {

/// A source frame of colours, and its points as they land on the pixels of the new frame.
struct SplatSource {
  const PointImage& image;
  const Motion& motion;
  const SplatBuffer& landed;
  float weight = 0.5f;  ///< weight of its colour; the weights of both sources add up to 1
};

/// Fills `film` (of the panel's size; missed pixels are black) and `missed` (ascending pixel indices). With a sampler, changing
/// colours are interpolated between the samples; both images must have its contrast. Without a sampler, pixels get the colours
/// of the points that land on them.
void average(const SplatSource& previous, const SplatSource& following, const EpipolarSampler* sampler, const ThreadPool& pool,
             Image& film, std::vector<std::uint32_t>& missed);

/// Computes the points that belong to the averaged colours, so that the frame can be the source of other frames. Each point
/// lies on its pixel's ray: at the mean depth of both points if they belong to one object, otherwise at the depth of the point
/// nearer to the viewer. Missed pixels get kMissedObject.
void average_points(const SplatSource& previous, const SplatSource& following, const ThreadPool& pool, PrimaryPoints& points);

}  // namespace lippmann
