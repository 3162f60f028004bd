// Estimates the costs of tracing frames and of making frames from others. The estimates use counts only, so they are the same
// on every machine and in every run.
//
// The costs decide which pixels are traced and thus must not depend on a clock. The weights were measured once (one thread, 512
// x 512 pixels, one sample each) and are accurate to about a third; only their ratios matter.
#pragma once

#include <cstdint>

#include "lippmann/scene/scene.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

/// Returns the seconds per ray of any kind, including shading: (5 + 8 n^(1/4)) ns for a scene of n triangles and other
/// primitives. Measured values and the formula's, in ns: Tachyon's room (27) 22, 23; smallballs (92) 25, 30; teapot (2.3
/// thousand) 70, 61; built-in small-balls (7 thousand) 67, 79; primitives (12) 72, 90; gears (53) 168, 126; room (87) 142, 142;
/// teapot (181) 166, 170; tree (894) 284, 251. Numbers of primitives of the last five are in thousands.
double seconds_per_ray(const Scene& scene);

/// Seconds per pixel for projection, colours and uncertainty of a predicted frame, without any tracing.
inline constexpr double kPredictionSecondsPerPixel = 50e-9;

/// Returns the cost of a prediction, in traced frames. `rays` are the ray counts of a traced frame.
double prediction_cost(const Scene& scene, const RayCounts& rays, std::uint64_t pixels);

/// Returns the cost of tracing part of a frame's packets, in traced frames, given their share of its rays. Uncertain packets
/// lie on fine geometry, where rays cost more than average.
double partial_tracing_cost(double share_of_rays);

}  // namespace lippmann
