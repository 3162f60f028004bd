// The colours of an in-between frame: the weighted mean of what has landed from the previous and the following frame.
//
// After the paper's interpolation: R, G, B are the mean of the two points' where both frames have one that lands on the pixel,
// the one point's where only one has, and the pixel is missed (status -1) where none has.
// We deviate: the nearer frame in time weighs more (in_between.cpp says how much); half way, as always in the paper's
// recursion, that is the mean.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "reuse/epipolar.hpp"
#include "reuse/motion.hpp"
#include "reuse/point_image.hpp"
#include "reuse/splat.hpp"

namespace lippmann {

/// A frame that colours come from, and what has landed of it.
struct SplatSource {
  const PointImage& image;
  const Motion& motion;
  const SplatBuffer& landed;
  float weight = 0.5f;  ///< what its colour counts beside the other's; both add up to 1
};

/// Fills `film` (of the panel's size; missed pixels black) and `missed` (ascending pixel indices). With a sampler, whose
/// contrast both images must have, colours are taken from between the samples where they change; without one, a point's colour
/// is taken as it is.
void average(const SplatSource& previous, const SplatSource& following, const EpipolarSampler* sampler, const ThreadPool& pool,
             Image& film, std::vector<std::uint32_t>& missed);

/// The points that go with these colours, for frames that are made from this one in turn: on each pixel's own ray at the mean
/// depth of the two points where both belong to one object, else at that of the one nearer to the viewer. Missed pixels get
/// kMissedObject.
void average_points(const SplatSource& previous, const SplatSource& following, const ThreadPool& pool, PrimaryPoints& points);

}  // namespace lippmann
