// Checks a parsed glTF document against the part of the glTF 2.0 schema that the reader uses.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

#include "scene/gltf/report.hpp"

namespace lippmann::gltf {

/// After it, every property that is left has its right type, range and length, every required one is there, and every index
/// refers to something that exists. Properties that the reader does not use (extras, foreign extensions, ...) are removed, so
/// that they cost nothing further on. Throws Error naming the element. Returns the names of all extensions that occur.
std::set<std::string> check_schema(nlohmann::json& root, const Report& report);

}  // namespace lippmann::gltf
