// A test pattern that shows whether a display matches its calibration. The colour of a pixel depends on where its ray crosses
// the display plane, and on where the ray arrives in the viewing zone.
//
// The display plane has a white frame, a grid and a circle. The viewing zone has five colours from left to right: red, orange,
// grey, cyan, blue. Red and orange show an arrow to the left, cyan and blue an arrow to the right. An eye in the middle of the
// zone should see a grey display. Other images indicate an error:
//   coloured stripes across the display     wrong pitch (upright stripes) or slant (leaning stripes)
//   one colour, but not grey                wrong centre
//   arrows that point away from the eye     reversed order of views
//   an oval instead of a circle             wrong aspect
#pragma once

#include <memory>
#include <string_view>

#include "frames/frame_maker.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

inline constexpr std::string_view kTestPattern = "test-pattern";

/// Returns a scene without objects and with one frame. It only defines the position of the display.
Scene test_pattern_scene();

/// Linear RGB of a ray that crosses the display at `place`, relative to its middle (x right, y up) in units of half its
/// height. `zone`: where the ray arrives in the viewing zone, from 0 (leftmost) to 1. `aspect`: width / height of the
/// display.
Vec3f test_pattern(Vec2f place, float aspect, float zone);

/// The frame maker traces no rays. The arguments must outlive it.
std::unique_ptr<FrameMaker> make_pattern_frames(const Stage& stage, const ThreadPool& pool);

Image test_pattern_film(const Optics& optics, const ThreadPool& pool);

}  // namespace lippmann
