#pragma once

#include <string>
#include <vector>

#include "scene/gltf/value.hpp"

namespace lippmann::gltf {

std::vector<std::string> names_in(Value array);

/// Returns the index of the element that `wanted`, a name or an index, selects. Names take precedence because an element may be
/// called "1". `parameter` is the name of the parameter whose value is `wanted`. If no element matches, throws a usage Error
/// that lists the names.
std::size_t choose(const char* parameter, const std::vector<std::string>& names, const std::string& wanted);

}  // namespace lippmann::gltf
