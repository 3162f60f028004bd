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

/// The places in the document where an extension occurs.
struct ExtensionUse {
  static constexpr std::size_t kMostNamed = 4;
  struct User {
    std::string where, name;  ///< "materials[2]", and the object's name, which may be empty
  };
  std::size_t count = 0;
  std::vector<User> users;  ///< the first kMostNamed users
};
using UsedExtensions = std::map<std::string, ExtensionUse>;

/// Extensions and properties that the schema tables do not cover.
struct SchemaFindings {
  UsedExtensions extensions;  ///< all that occur
  LeftOut unknown;            ///< properties that glTF 2.0 does not define, outside extras and extensions
};

/// Checks the document: afterwards every remaining property has the right type, range and length, every required one exists,
/// and every index is valid. Removes properties that the reader does not use (extras, unknown extensions, ...). Throws Error
/// naming the element.
SchemaFindings check_schema(nlohmann::json& root, const Report& report);

}  // namespace lippmann::gltf
