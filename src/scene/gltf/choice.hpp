// Selects an element of a glTF file by name or index.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/value.hpp"

namespace lippmann::gltf {

/// Returns the name of every element of an array.
std::vector<std::string> names_in(Value array);

/// Returns the index that `wanted` selects: a name or an index. Names take precedence, since an element may be called "1".
/// `parameter`: the parameter that `wanted` came from. Throws a usage Error listing the names if there is no match.
std::size_t choose(const char* parameter, const std::vector<std::string>& names, const std::string& wanted);

}  // namespace lippmann::gltf
