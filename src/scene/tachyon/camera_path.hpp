// Reads a Tachyon camera path (.cam): one pose per line, nine numbers: view direction, up, centre.
#pragma once

#include <vector>

#include "scene/tachyon/camera.hpp"

namespace lippmann::tachyon {

/// Returns all poses, at least one. Throws Error with the line for incomplete poses or numbers that are not finite.
std::vector<CameraPose> parse_camera_path(Lexer& lexer);

/// Moves `node` through the poses, one per frame, with step interpolation. Tachyon renders the last pose twice because its
/// reader detects the end of the file one read late. So N poses make N + 1 frames, and the frame numbers match those of
/// Tachyon's images. timeline.frames_per_second must be set.
void animate(Timeline& timeline, int node, const std::vector<CameraPose>& poses);

}  // namespace lippmann::tachyon
