// The six built-in scenes: teapot, room, small-balls, primitives, tree and gears. Each has a seamless animation of at least 400
// frames.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

struct BuiltinScene {
  std::string_view name{};
  std::string_view description{};  ///< one line of text, printed by `lippmann scenes`
  Scene (*build)() = nullptr;
};

/// Returns the built-in scenes in this order: teapot, room, small-balls, primitives, tree, gears.
const std::vector<BuiltinScene>& builtin_scenes();

}  // namespace lippmann
