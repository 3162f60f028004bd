// Resolves the names in a ViewWish, and parses its numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/view_wish.hpp"

namespace lippmann {

/// Returns for each instance whether `name`, the name of a node or an instance, selects it. Throws a usage Error naming `flag`
/// if nothing has this name, or if no shape is below the node.
std::vector<bool> instances_named(const Scene& scene, const std::string& name, const char* flag);

bool is_name_of_node(const Scene& scene, std::string_view name);

/// Parses degrees such as "-30" (yaw) or "-30,15" (yaw and pitch). Throws a usage Error at `where`.
Orbit read_orbit(std::string_view text, const std::string& where);
std::string write_orbit(const Orbit& orbit);

/// Parses one or three numbers separated by commas. For other text, throws a usage Error at `focus` that lists
/// the nodes of the scene.
std::vector<double> read_focus(const Scene& scene, const std::string& text);

}  // namespace lippmann
