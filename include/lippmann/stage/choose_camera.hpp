// Selects the camera that defines the view, by name or index, and makes a file's up axis vertical.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

enum class UpAxis { kY, kX, kZ, kMinusX, kMinusY, kMinusZ };

/// Returns the names of the scene's cameras in the file's order. Unnamed cameras have an empty name.
std::vector<std::string> camera_names(const Scene& scene);

/// Returns the values that choose_camera() accepts, such as "Front (0), Side (1)".
std::string list_cameras(const std::vector<std::string>& names);

/// Moves the camera with the given name, or else with that index, to the front of the scene's list. The first camera defines
/// the view, even if the scene places an array of its own. An empty string changes nothing. Throws a usage Error that lists the
/// cameras.
void choose_camera(Scene& scene, const std::string& wanted);

/// Moves the camera with the given index to the front of the scene's list. Throws a usage Error that lists the cameras.
void choose_camera(Scene& scene, std::size_t index);

/// Rotates the whole scene about the origin so that the axis `up` of the file becomes +y.
void turn_upright(Scene& scene, UpAxis up);

}  // namespace lippmann
