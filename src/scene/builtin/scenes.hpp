#pragma once

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

Scene build_teapot();
Scene build_room();
Scene build_small_balls();
Scene build_primitives();
Scene build_tree();
Scene build_gears();

}  // namespace lippmann::builtin
