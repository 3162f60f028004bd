// Which of a scene's cameras decides the view, by name or index, and which axis of a file points upwards.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

enum class UpAxis { kY, kX, kZ, kMinusX, kMinusY, kMinusZ };

/// What the scene's cameras are called, in the file's order; an empty name where one has none.
std::vector<std::string> camera_names(const Scene& scene);

/// "Front (0), Side (1)": what choose_camera() accepts.
std::string list_cameras(const std::vector<std::string>& names);

/// Puts the camera of that name, or else of that index, first: the first one decides the view, also where the scene places an
/// array of its own. Empty: changes nothing. Throws a usage Error that lists the cameras.
void choose_camera(Scene& scene, const std::string& wanted);

/// The same by index alone, for callers that know it is one. Throws a usage Error that lists the cameras.
void choose_camera(Scene& scene, std::size_t index);

/// Turns all of the scene about the origin so that what points along `up` in the file points along +y.
void turn_upright(Scene& scene, UpAxis up);

}  // namespace lippmann
