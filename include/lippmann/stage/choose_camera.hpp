// Selects the camera that defines the view, by name or index, and the up axis of a file.
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

/// Moves the camera with the given name, or else with that index, to the front. The first camera defines the view, even if the
/// scene places an array of its own. An empty string changes nothing. Throws a usage Error that lists the cameras.
void choose_camera(Scene& scene, const std::string& wanted);

/// The same by index only. Throws a usage Error that lists the cameras.
void choose_camera(Scene& scene, std::size_t index);

/// Rotates the whole scene about the origin so that the file's axis `up` becomes +y.
void turn_upright(Scene& scene, UpAxis up);

}  // namespace lippmann
