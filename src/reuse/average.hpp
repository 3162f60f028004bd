// The colours of an in-between frame: the weighted mean of the points that land from the previous and the following frame.
//
// After the paper's interpolation: R, G, B are the mean of the two points if both frames have a point that lands on the pixel,
// or those of the only point. Without a point, the pixel is missed (status -1).
// This implementation deviates in one point: the frame nearer in time has more weight (see in_between.cpp). Half way, which is
// the only case in the paper's recursion, the weights are equal.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "reuse/epipolar.hpp"
#include "reuse/motion.hpp"
#include "reuse/point_image.hpp"
#include "reuse/splat.hpp"

namespace lippmann {

/// A source frame of colours, and its landed points.
struct SplatSource {
  const PointImage& image;
  const Motion& motion;
  const SplatBuffer& landed;
  float weight = 0.5f;  ///< weight of its colour; the weights of both sources add up to 1
};

/// Fills `film` (of the panel's size; missed pixels are black) and `missed` (ascending pixel indices). With a sampler, changing
/// colours are interpolated between the samples; both images must have its contrast. Without a sampler, the point's colour is
/// used.
void average(const SplatSource& previous, const SplatSource& following, const EpipolarSampler* sampler, const ThreadPool& pool,
             Image& film, std::vector<std::uint32_t>& missed);

/// Computes the points of the averaged colours, so that the frame can be the source of other frames. Each point lies on its
/// pixel's ray: at the mean depth of both points if they belong to one object, otherwise at the depth of the point nearer to
/// the viewer. Missed pixels get kMissedObject.
void average_points(const SplatSource& previous, const SplatSource& following, const ThreadPool& pool, PrimaryPoints& points);

}  // namespace lippmann
