// Computes the colours of an in-between frame from the projected points of the previous and the following frame.
//
// Based on the interpolation of Eljdid, Aggoun and Youssef (README.md). If points of both frames land on a pixel, the pixel's
// colour is the weighted mean of their colours. If one point lands, the pixel gets that point's colour. If no point lands, the
// pixel is missed (status -1 in the paper). We deviate: the frame nearer in time has a larger weight (see in_between.cpp). The
// paper makes only frames half way between two others, where both weights are equal.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "reuse/epipolar.hpp"
#include "reuse/motion.hpp"
#include "reuse/point_image.hpp"
#include "reuse/splat.hpp"

namespace lippmann {

/// A source frame, and its points projected to the new frame.
struct SplatSource {
  const PointImage& image;
  const Motion& motion;
  const SplatBuffer& landed;
  /// Weight of the colours of this source. The weights of both sources add up to 1.
  float weight = 0.5f;
};

/// Sets `film` to the averaged colours and `missed` to the missed pixels (ascending). `film` must have the panel's size. Missed
/// pixels become black. With a sampler, colours that change between neighbouring samples are interpolated, for which both
/// images need PointImage::contrast. Without a sampler, pixels get the colours of the points that land on them.
void average(const SplatSource& previous, const SplatSource& following, const EpipolarSampler* sampler, const ThreadPool& pool,
             Image& film, std::vector<std::uint32_t>& missed);

/// Computes the points of the averaged frame, so that the frame can be a source of other frames. Each point lies on the ray of
/// its pixel. If both landed points belong to one object, the result has their mean depth. Otherwise the result is the point
/// nearer to the viewer. Missed pixels get kMissedObject.
void average_points(const SplatSource& previous, const SplatSource& following, const ThreadPool& pool, PrimaryPoints& points);

}  // namespace lippmann
