// A picture that shows at a glance whether a display and its calibration belong together. It is made of rays alone: what a
// pixel shows depends on where its ray crosses the plane of the display, and on where in the viewing zone it arrives.
//
// In the plane of the display: a white frame, a grid, a circle. By direction, from the left of the zone to its right: red,
// orange, grey, cyan, blue, red and orange with an arrow to the left, cyan and blue with one to the right. An eye in the
// middle of the zone then sees one grey display. What it sees instead tells the error:
//   stripes of colours across the display     the pitch is wrong (upright stripes), or the slope (leaning ones)
//   one colour, but not grey                  the centre is wrong
//   arrows that point away from the eye       the order of views is reversed
//   an oval                                   the aspect is wrong
#pragma once

#include <memory>
#include <string_view>

#include "frames/frame_maker.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// The name under which `render` makes it, in place of a scene's.
inline constexpr std::string_view kTestPattern = "test-pattern";

/// A scene of nothing, on whose array the pattern is shown: one frame.
Scene test_pattern_scene();

/// Linear RGB where a ray crosses the display at `place`, in half heights from its middle (x right, y up), of a display of that
/// aspect, and comes from `zone`, 0 (leftmost) to 1.
Vec3f test_pattern(Vec2f place, float aspect, float zone);

/// Its frames, for which no ray has to be traced. All arguments outlive the result.
std::unique_ptr<FrameMaker> make_pattern_frames(const Stage& stage, const ThreadPool& pool);

/// The whole film.
Image test_pattern_film(const Optics& optics, const ThreadPool& pool);

}  // namespace lippmann
