// What it costs to trace frames, and to make them from others, told from counts: the same on every machine and at every time.
//
// Whether a predicted frame pays decides which pixels are traced, so that it must not depend on a clock. The weights here were
// measured once (one thread, 512 x 512 pixels, one sample each) and are good to about a third; only their ratios count.
#pragma once

#include <cstdint>

#include "lippmann/scene/scene.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

/// Seconds per ray of any kind, shading included: (5 + 8 n^(1/4)) ns for a scene of n triangles and other primitives.
/// Measured and by formula, ns: Tachyon's room (27) 22, 23; smallballs (92) 25, 30; teapot (2.3 thousand) 70, 61; built-in
/// small-balls (7 thousand) 67, 79; primitives (12) 72, 90; gears (53) 168, 126; room (87) 142, 142; teapot (181) 166, 170;
/// tree (894) 284, 251.
double seconds_per_ray(const Scene& scene);

/// Seconds that projection, colours and uncertainty of a predicted frame take per pixel, whatever is traced of it.
inline constexpr double kPredictionSecondsPerPixel = 50e-9;

/// What making the prediction costs, in traced frames. `rays`: those that a traced frame takes.
double prediction_cost(const Scene& scene, const RayCounts& rays, std::uint64_t pixels);

/// What tracing part of a frame's packets costs, in traced frames, where they have that share of its rays. What is uncertain is
/// where geometry is fine, and dearer by ray than the rest.
double partial_tracing_cost(double share_of_rays);

}  // namespace lippmann
