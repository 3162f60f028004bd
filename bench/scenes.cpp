#include "bench/scenes.hpp"

#include <algorithm>
#include <filesystem>

#include "scene/builtin.hpp"

namespace lippmann::bench {
namespace {

bool is_wanted(const Request& request, const std::string& name) {
  return request.scenes.empty() || std::find(request.scenes.begin(), request.scenes.end(), name) != request.scenes.end();
}

}  // namespace

std::vector<BenchScene> bench_scenes(const Request& request, const Context& context) {
  std::vector<std::string> names = request.scenes;
  if (names.empty())
    for (const BuiltinScene& builtin : builtin_scenes()) names.emplace_back(builtin.name);
  std::vector<BenchScene> result;
  for (const std::string& name : names) {
    BenchScene scene{name, {}, 0};
    scene.params.scene = name;
    scene.frame = load_scene(name, {}, context).timeline.frame_count / 3;
    result.push_back(std::move(scene));
  }
  return result;
}

std::vector<BenchScene> tachyon_scenes(const Request& request) {
  std::vector<BenchScene> result;
  for (const std::string name : {"teapot", "room", "smallballs"}) {
    const std::filesystem::path file = std::filesystem::path(request.tachyon_scenes) / (name + ".dat");
    if (!is_wanted(request, name) || !std::filesystem::exists(file)) continue;
    BenchScene scene{name, {}, 0};
    scene.params.scene = file.string();
    result.push_back(std::move(scene));
  }
  return result;
}

}  // namespace lippmann::bench
