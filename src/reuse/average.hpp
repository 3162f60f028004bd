// Computes the colours of an in-between frame from the projected points of the previous and the following frame.
//
// Based on the interpolation of Eljdid, Aggoun and Youssef (README.md). If points of both frames land on a pixel, its colour is
// their weighted mean. If one point lands, its colour is used. If none lands, the pixel is missed (status -1 in the paper).
//
// We deviate: the frame nearer in time has a larger weight. The paper makes only frames half way between two others.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "reuse/epipolar.hpp"
#include "reuse/motion.hpp"
#include "reuse/point_image.hpp"
#include "reuse/splat.hpp"

namespace lippmann {

struct SplatSource {
  const PointImage& image;
  const Motion& motion;
  const SplatBuffer& landed;
  /// Weight of this source's colours. The weights of both sources add up to 1.
  float weight = 0.5f;
};

/// Sets `film` to the mean colours and `missed` to the ascending indices of the missed pixels, which become black. If `sampler`
/// is given, colours that change between neighbouring samples are interpolated. This requires PointImage::contrast of both
/// images.
void average(const SplatSource& previous, const SplatSource& following, const EpipolarSampler* sampler, const ThreadPool& pool,
             Image& film, std::vector<std::uint32_t>& missed);

/// Computes the points of the averaged frame. Two points of one object are replaced by a point at their mean depth. Otherwise
/// the point nearer to the viewer is taken. Missed pixels get kMissedObject.
void average_points(const SplatSource& previous, const SplatSource& following, const ThreadPool& pool, PrimaryPoints& points);

}  // namespace lippmann
