// Scenes that are hard to denoise. They are built in code, and each has one difficulty.
//
// Lengths are metres, +y is up, materials are those of glTF. Each scene is an animation of 16 frames, 25 per second, in which
// objects move by several pixels per frame.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

struct HostileScene {
  std::string name;
  std::string difficulty;        ///< one line on the difficulty
  std::function<Scene()> build;  ///< builds the scene, which passes validate()
  RenderParams params;           ///< optics, size and samples of path tracing
  int frames = 16;
};

/// Returns the scenes in the order of lists and runs.
const std::vector<HostileScene>& hostile_scenes();

}  // namespace lippmann::bench
