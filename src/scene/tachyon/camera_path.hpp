// Reads a Tachyon camera path (.cam): one pose a line, nine numbers: view direction, up, centre.
#pragma once

#include <vector>

#include "scene/tachyon/camera.hpp"

namespace lippmann::tachyon {

/// All poses, at least one. Throws Error with the line for anything but whole poses of finite numbers.
std::vector<CameraPose> parse_camera_path(Lexer& lexer);

/// Moves `node` through the poses, one a frame, each held until the next. Tachyon renders the last pose twice (its reader finds
/// the end of the file one read late), so N poses make N + 1 frames, whose numbers then agree with Tachyon's pictures.
/// timeline.frames_per_second must be set.
void animate(Timeline& timeline, int node, const std::vector<CameraPose>& poses);

}  // namespace lippmann::tachyon
