// Scenes on which sharing light between pixels, views and frames is hard, built in code: of each, one thing that goes wrong.
//
// Lengths are metres, +y is up, materials are glTF's. Each is an animation of one history: 16 frames, 25 a second, in which
// what moves does so by several pixels a frame.
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
  int row_share = 1;       ///< one panel row of so many is compared, as LightCase has it
  int reference_step = 3;  ///< one frame of so many is compared, likewise
};

/// In the order in which they are listed and run.
const std::vector<HostileScene>& hostile_scenes();

}  // namespace lippmann::bench
