// Scenes that are hard to denoise, each with one difficulty.
//
// Lengths are in metres, +y points upwards, and materials are those of glTF. Each scene is an animation of 16 frames at 25
// frames per second, in which objects move by several pixels per frame.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

struct HostileScene {
  std::string name;
  std::string difficulty;
  std::function<Scene()> build;
  RenderParams params;
  int frames = 16;
};

const std::vector<HostileScene>& hostile_scenes();

}  // namespace lippmann::bench
