#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/gltf/report.hpp"
#include "scene/left_out.hpp"

namespace lippmann::gltf {

struct ExtensionUse {
  static constexpr std::size_t kMostNamed = 4;
  struct User {
    std::string where, name;
  };
  std::size_t count = 0;
  std::vector<User> users;
};
using UsedExtensions = std::map<std::string, ExtensionUse>;

struct SchemaFindings {
  UsedExtensions extensions;
  LeftOut unknown;
};

/// Checks the document. Afterwards every remaining property has the right type, range and length, every required property
/// exists, and every index is valid. Removes the properties that the reader does not use. Throws Error naming the element.
SchemaFindings check_schema(nlohmann::json& root, const Report& report);

}  // namespace lippmann::gltf
