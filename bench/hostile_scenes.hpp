// Scenes whose light is hard to denoise, built in code; each has one difficulty.
//
// Lengths are metres, +y is up, materials are glTF's. Each is an animation of 16 frames, 25 a second, in which things move by
// several pixels a frame.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "job/params.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

struct HostileScene {
  std::string name;
  std::string difficulty;        ///< what is hard about it, one line
  std::function<Scene()> build;  ///< passes validate()
  RenderParams params;           ///< optics, size and samples of path tracing
  int frames = 16;
};

/// In the order in which they are listed and run.
const std::vector<HostileScene>& hostile_scenes();

}  // namespace lippmann::bench
