// Selects the camera that defines the view, and turns a scene so that its file's up axis becomes vertical.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

enum class UpAxis { kY, kX, kZ, kMinusX, kMinusY, kMinusZ };

/// Returns the names of all cameras. The name of a camera without one is empty.
std::vector<std::string> camera_names(const Scene& scene);

/// Returns the names with their indices as one text, for example "Front (0), Side (1)".
std::string list_cameras(const std::vector<std::string>& names);

/// Moves the camera whose name or index is `wanted` to the front of the list, because the first camera defines the view. An
/// empty string changes nothing. Throws a usage Error that lists the cameras.
void choose_camera(Scene& scene, const std::string& wanted);

/// Makes the camera with the index `index` the first one. Throws a usage Error that lists the cameras.
void choose_camera(Scene& scene, std::size_t index);

/// Rotates the scene about the origin so that the axis `up` of the file becomes +y.
void turn_upright(Scene& scene, UpAxis up);

}  // namespace lippmann
