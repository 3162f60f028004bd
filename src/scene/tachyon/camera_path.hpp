// Reads a Tachyon camera path (.cam). Each line is a pose of nine numbers: view direction, up, centre.
#pragma once

#include <vector>

#include "scene/tachyon/camera.hpp"

namespace lippmann::tachyon {

/// Returns at least one pose. Throws Error with the line for incomplete poses and for numbers that are not finite.
std::vector<CameraPose> parse_camera_path(Lexer& lexer);

/// Moves `node` through the poses, one per frame, with step interpolation. N poses make N + 1 frames because Tachyon renders
/// the last pose twice. timeline.frames_per_second must be set.
void animate(Timeline& timeline, int node, const std::vector<CameraPose>& poses);

}  // namespace lippmann::tachyon
