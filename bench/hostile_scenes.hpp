// Scenes that are hard to denoise. Each scene is built in code and has one difficulty.
//
// Lengths are in metres, +y points upwards, and materials are those of glTF. Each scene is an animation of 16 frames at 25
// frames per second. Its objects move by several pixels per frame.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

struct HostileScene {
  std::string name;
  std::string difficulty;        ///< describes the difficulty in one line
  std::function<Scene()> build;  ///< builds the scene, which must pass validate()
  RenderParams params;           ///< optics, size and samples of path tracing
  int frames = 16;
};

/// Returns the scenes in the order of lists and runs.
const std::vector<HostileScene>& hostile_scenes();

}  // namespace lippmann::bench
