// What of a file a user chooses by name or by index.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/value.hpp"

namespace lippmann::gltf {

/// The name of every element of an array.
std::vector<std::string> names_in(Value array);

/// The index of `wanted`, which is one of the names or an index; names first: something may be called "1". parameter: the one
/// that said it. Throws a usage Error that lists the names where it is neither.
std::size_t choose(const char* parameter, const std::vector<std::string>& names, const std::string& wanted);

}  // namespace lippmann::gltf
