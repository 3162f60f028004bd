// Checks the JSON of a glTF document against the part of the glTF 2.0 schema that the reader uses.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/gltf/report.hpp"
#include "scene/left_out.hpp"

namespace lippmann::gltf {

/// The objects of the document that use an extension.
struct ExtensionUse {
  static constexpr std::size_t kMostNamed = 4;
  struct User {
    std::string where, name;  ///< path, such as "materials[2]", and name, which may be empty
  };
  std::size_t count = 0;
  std::vector<User> users;  ///< the first kMostNamed objects; `count` includes all
};
using UsedExtensions = std::map<std::string, ExtensionUse>;

/// Results of the schema check that are not errors.
struct SchemaFindings {
  UsedExtensions extensions;
  LeftOut unknown;  ///< properties that glTF 2.0 does not define, outside extras and extensions
};

/// Checks the document. Afterwards every remaining property has the right type, range and length, every required property
/// exists, and every index is valid. Removes the properties that the reader does not use, such as unknown extensions. Throws
/// Error naming the element.
SchemaFindings check_schema(nlohmann::json& root, const Report& report);

}  // namespace lippmann::gltf
