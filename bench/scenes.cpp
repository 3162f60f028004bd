#include "bench/scenes.hpp"

#include <algorithm>
#include <filesystem>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/builtin.hpp"

namespace lippmann::bench {
namespace {

bool is_wanted(const Request& request, const std::string& name) {
  return request.scenes.empty() || std::find(request.scenes.begin(), request.scenes.end(), name) != request.scenes.end();
}

}  // namespace

RenderParams params_of(const std::string& scene) {
  RenderParams params;
  params.scene.name = scene;
  params.optics.fit_depth = false;
  return params;
}

std::vector<BenchScene> bench_scenes(const Request& request, const Context& context) {
  std::vector<std::string> names = request.scenes;
  if (names.empty())
    for (const BuiltinScene& builtin : builtin_scenes()) names.emplace_back(builtin.name);
  std::vector<BenchScene> result;
  for (const std::string& name : names) {
    BenchScene scene{name, params_of(name), 0};
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
    result.push_back({name, params_of(file.string()), 0});
  }
  return result;
}

std::vector<BenchAnimation> bench_animations(const Request& request, const Context& context) {
  constexpr int kFrames = 48, kTachyonFrames = 24, kTachyonFirst = 96, kLargeFrames = 17;  // the paper shows frames 103 to 109
  std::vector<BenchAnimation> result;
  std::string known;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const std::string name(builtin.name);
    known += name + ", ";
    if (!is_wanted(request, name)) continue;
    const int all = load_scene(name, {}, context).timeline.frame_count;
    result.push_back({name, params_of(name), 0, std::min(request.frames > 0 ? request.frames : kFrames, all)});
  }
  for (const BenchScene& scene : tachyon_scenes(request)) {
    const std::filesystem::path path = std::filesystem::path(scene.params.scene.name).replace_extension(".cam");
    if (!std::filesystem::exists(path)) continue;
    RenderParams params = scene.params;
    params.scene.camera_path = path.string();
    const int all = wanted_scene(params, context).timeline.frame_count;
    const int wanted = request.frames > 0 ? request.frames : kTachyonFrames;
    const int first = request.frames > all - kTachyonFirst ? 0 : kTachyonFirst;
    result.push_back({"tachyon " + scene.name, std::move(params), first, std::min(wanted, all - first)});
  }
  if (request.large && is_wanted(request, "teapot")) {
    BenchAnimation large{"teapot 3840x2160", params_of("teapot"), 0, request.frames > 0 ? request.frames : kLargeFrames};
    large.params.optics.size = {3840, 2160};
    large.params.optics.lens_pixels = {10.0f, 10.0f};
    result.push_back(std::move(large));
  }
  if (result.empty())
    throw usage_error("--scene", "no such animation", known + "or one of Tachyon's: teapot, room, smallballs");
  return result;
}

}  // namespace lippmann::bench
