// The six scenes after the paper's, built by code, each with a seamless animation of at least 400 frames.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct BuiltinScene {
  std::string_view name;
  std::string_view description;  ///< one line for `lippmann scenes`
  Scene (*build)();
};

/// teapot, room, small-balls, primitives, tree, gears.
const std::vector<BuiltinScene>& builtin_scenes();

}  // namespace lippmann
