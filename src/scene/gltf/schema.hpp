// Checks a parsed glTF document against the part of the glTF 2.0 schema that the reader uses.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/gltf/report.hpp"
#include "scene/left_out.hpp"

namespace lippmann::gltf {

/// Where in the document an extension occurs.
struct ExtensionUse {
  static constexpr std::size_t kMostNamed = 4;
  struct User {
    std::string where, name;  ///< "materials[2]"; its name in the file, which may be empty
  };
  std::size_t count = 0;
  std::vector<User> users;  ///< the first kMostNamed
};
using UsedExtensions = std::map<std::string, ExtensionUse>;

/// Objects whose properties the schema does not list in full.
struct SchemaFindings {
  UsedExtensions extensions;  ///< all that occur
  LeftOut unknown;            ///< properties that glTF 2.0 does not have, outside extras and extensions
};

/// After it, every property that is left has its right type, range and length, every required one is there, and every index
/// refers to something that exists. Properties that the reader does not use (extras, foreign extensions, ...) are removed, so
/// that they cost nothing further on. Throws Error naming the element.
SchemaFindings check_schema(nlohmann::json& root, const Report& report);

}  // namespace lippmann::gltf
