// A test pattern that shows at a glance whether a display and its calibration match. It is computed from rays alone: the colour
// of a pixel depends on where its ray crosses the display plane, and on where it arrives in the viewing zone.
//
// In the display plane: a white frame, a grid, a circle. By direction, from left to right in the zone: red, orange, grey, cyan,
// blue. Red and orange have an arrow to the left, cyan and blue one to the right. An eye in the middle of the zone should see a
// grey display. Other images indicate the error:
//   coloured stripes across the display     wrong pitch (upright stripes) or slope (leaning stripes)
//   one colour, but not grey                wrong centre
//   arrows that point away from the eye     reversed order of views
//   an oval                                 wrong aspect
#pragma once

#include <memory>
#include <string_view>

#include "frames/frame_maker.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// The name of the pattern for `render`, in place of a scene.
inline constexpr std::string_view kTestPattern = "test-pattern";

/// Returns an empty scene with one frame. The array to show the pattern on is part of the scene.
Scene test_pattern_scene();

/// Returns the linear RGB of a ray that crosses the display at `place`, in half heights from its middle (x right, y up), and
/// arrives at `zone`, from 0 (leftmost) to 1. aspect: width / height of the display.
Vec3f test_pattern(Vec2f place, float aspect, float zone);

/// Returns a maker of the pattern's frames, which traces no rays. The arguments must outlive the result.
std::unique_ptr<FrameMaker> make_pattern_frames(const Stage& stage, const ThreadPool& pool);

/// Returns a film that shows the pattern.
Image test_pattern_film(const Optics& optics, const ThreadPool& pool);

}  // namespace lippmann
