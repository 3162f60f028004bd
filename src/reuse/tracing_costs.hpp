// Estimates the costs of tracing frames and of making frames from other frames.
//
// The costs decide which pixels are traced. They depend on counts and not on a clock, so that every machine makes the same
// decisions. The constants were measured with one thread, 512 x 512 pixels and one sample per pixel. They are accurate to about
// a third.
#pragma once

#include <cstdint>

#include "lippmann/scene/scene.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

/// Returns the estimated seconds per ray of any kind, including shading: (5 + 8 n^(1/4)) ns, where n is the number of triangles
/// and other primitives. The measured and the computed ns per ray are:
///   Tachyon's room (n = 27): 22, 23
///   smallballs (92): 25, 30
///   teapot (2,300): 70, 61
///   built-in small-balls (7,000): 67, 79
///   primitives (12,000): 72, 90
///   gears (53,000): 168, 126
///   room (87,000): 142, 142
///   teapot (181,000): 166, 170
///   tree (894,000): 284, 251
double seconds_per_ray(const Scene& scene);

/// Cost of predicting a frame (projection, colours and uncertainty), in seconds per pixel.
inline constexpr double kPredictionSecondsPerPixel = 50e-9;

/// Returns the cost of predicting a frame relative to tracing it. `rays` are the ray counts of a traced frame.
double prediction_cost(const Scene& scene, const RayCounts& rays, std::uint64_t pixels);

/// Returns the cost of tracing part of a frame relative to the whole frame. `share_of_rays` is the part's fraction of the rays.
/// The cost is higher than this fraction, because uncertain predictions lie on fine geometry, where rays cost more.
double partial_tracing_cost(double share_of_rays);

}  // namespace lippmann
