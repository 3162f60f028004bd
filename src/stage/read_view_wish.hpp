// Resolves the names in a ViewWish, and parses its numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/view_wish.hpp"

namespace lippmann {

/// Returns one flag per instance: true if `name` selects the instance. Throws a usage Error at `flag` if the name does not
/// exist, with the most similar name. Also throws if there is no shape below the node.
std::vector<bool> instances_named(const Scene& scene, const std::string& name, const char* flag);

/// Returns whether a node or an instance is called `name`.
bool is_name_of_node(const Scene& scene, std::string_view name);

/// Parses an orbit in degrees, such as "-30" (yaw) or "-30,15" (yaw and pitch). Throws a usage Error at `where`.
Orbit read_orbit(std::string_view text, const std::string& where);
std::string write_orbit(const Orbit& orbit);

/// Parses one or three numbers separated by commas. For any other text, throws a usage Error at `focus` that suggests names of
/// the scene.
std::vector<double> read_focus(const Scene& scene, const std::string& text);

}  // namespace lippmann
