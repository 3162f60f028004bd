// Reads a Tachyon camera path (.cam). Each line is a pose of nine numbers: view direction, up, centre.
#pragma once

#include <vector>

#include "scene/tachyon/camera.hpp"

namespace lippmann::tachyon {

/// Returns all poses. There is at least one. Throws Error with the line for incomplete poses and for numbers that are not
/// finite.
std::vector<CameraPose> parse_camera_path(Lexer& lexer);

/// Moves `node` through the poses, one per frame, with step interpolation. N poses make N + 1 frames because the last pose is
/// repeated: Tachyon renders it twice since its reader detects the end of the file one read late. The repetition keeps the
/// frame numbers of Tachyon's images. timeline.frames_per_second must be set.
void animate(Timeline& timeline, int node, const std::vector<CameraPose>& poses);

}  // namespace lippmann::tachyon
