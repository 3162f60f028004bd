// Selects the camera that defines the view, by name or by index. Also turns a scene so that the up axis of its file becomes
// vertical.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

enum class UpAxis { kY, kX, kZ, kMinusX, kMinusY, kMinusZ };

/// Returns the names of the scene's cameras in the order of the file. Cameras without a name have an empty string.
std::vector<std::string> camera_names(const Scene& scene);

/// Returns a list of the values that choose_camera() accepts, such as "Front (0), Side (1)".
std::string list_cameras(const std::vector<std::string>& names);

/// Moves a camera to the front of the scene's list of cameras. The first camera defines the view, even if the scene places its
/// own lens array. `wanted` is the name of the camera, or its index if no camera has this name. An empty string changes
/// nothing. Throws a usage Error that lists the cameras.
void choose_camera(Scene& scene, const std::string& wanted);

/// Moves the camera with the index `index` to the front of the scene's list of cameras. Throws a usage Error that lists the
/// cameras.
void choose_camera(Scene& scene, std::size_t index);

/// Rotates the whole scene about the origin so that the axis `up` of the file becomes +y.
void turn_upright(Scene& scene, UpAxis up);

}  // namespace lippmann
