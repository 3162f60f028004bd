// Finds in a scene what a ViewWish names, and reads its numbers from text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/view_wish.hpp"

namespace lippmann {

/// Which instances a name means, one flag for each. Throws a usage Error at `flag` where there is no such name, with the
/// nearest one, or where nothing is shown below it.
std::vector<bool> instances_named(const Scene& scene, const std::string& name, const char* flag);

/// Whether a node or an instance has that name.
bool is_name_of_node(const Scene& scene, std::string_view name);

/// "-30" or "-30,15", in degrees. Throws a usage Error at `where`.
Orbit read_orbit(std::string_view text, const std::string& where);
std::string write_orbit(const Orbit& orbit);

/// The numbers between commas: one or three. Throws a usage Error at --focus where `text` is neither; the scene's names are
/// what the Error then suggests.
std::vector<double> read_focus(const Scene& scene, const std::string& text);

}  // namespace lippmann
