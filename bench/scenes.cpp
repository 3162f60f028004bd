#include "bench/scenes.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "job/job_scene.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/builtin.hpp"

namespace lippmann::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTachyonNames[] = {"teapot", "room", "smallballs"};

bool is_wanted(const Request& request, const std::string& name) {
  return request.scenes.empty() || std::find(request.scenes.begin(), request.scenes.end(), name) != request.scenes.end();
}

bool is_tachyons(const std::string& name) {
  return std::find(std::begin(kTachyonNames), std::end(kTachyonNames), name) != std::end(kTachyonNames);
}

std::vector<std::string> missing_tachyon_files(const Request& request) {
  std::vector<std::string> missing;
  for (const std::string name : kTachyonNames)
    for (const std::string& file : {name + ".dat", name + ".cam"})
      if (is_wanted(request, name) && !fs::exists(fs::path(request.tachyon_scenes) / file)) missing.push_back(file);
  return missing;
}

Error no_tachyon_scenes(const Request& request) {
  return {request.tachyon_scenes, fmt::format("has no {}", fmt::join(missing_tachyon_files(request), ", ")),
          "a folder with Tachyon's scenes (--tachyon-scenes DIR); Debian has them in the package tachyon-doc"};
}

void require_animations(const Request& request) {
  std::string known;
  for (const BuiltinScene& builtin : builtin_scenes()) known += std::string(builtin.name) + ", ";
  const std::vector<std::string> missing = missing_tachyon_files(request);
  for (const std::string& name : request.scenes) {
    if (is_builtin_scene(name)) continue;
    if (!is_tachyons(name))
      throw usage_error("--scene", fmt::format("there is no animation '{}'", name),
                        known + fmt::format("or one of Tachyon's: {}", fmt::join(kTachyonNames, ", ")));
    if (std::any_of(missing.begin(), missing.end(), [&](const std::string& file) { return file.starts_with(name + "."); }))
      throw no_tachyon_scenes(request);
  }
}

/// Without Tachyon's files, the benchmark continues with the built-in scenes "teapot" and "room", which have the names of two
/// of Tachyon's scenes.
void warn_of_missing_tachyon_files(const Request& request, const Context& context) {
  const std::vector<std::string> missing = missing_tachyon_files(request);
  if (missing.empty()) return;
  context.warning(
      fmt::format("Tachyon's scenes and the columns that compare with the paper are left out: {} has no {}. "
                  "Install Debian's package tachyon-doc, or name another folder with --tachyon-scenes.",
                  request.tachyon_scenes, fmt::join(missing, ", ")));
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
  for (const std::string name : kTachyonNames) {
    const fs::path file = fs::path(request.tachyon_scenes) / (name + ".dat");
    if (is_wanted(request, name) && fs::exists(file)) result.push_back({name, params_of(file.string()), 0});
  }
  return result;
}

std::vector<BenchAnimation> bench_animations(const Request& request, const Context& context) {
  // the paper shows frames 103 to 109 of Tachyon's animations
  constexpr int kFrames = 48, kTachyonFrames = 24, kTachyonFirst = 96, kLargeFrames = 17;
  require_animations(request);
  warn_of_missing_tachyon_files(request, context);
  std::vector<BenchAnimation> result;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    const std::string name(builtin.name);
    if (!is_wanted(request, name)) continue;
    const int all = load_scene(name, {}, context).timeline.frame_count;
    result.push_back({name, params_of(name), 0, std::min(request.frames > 0 ? request.frames : kFrames, all)});
  }
  for (const BenchScene& scene : tachyon_scenes(request)) {
    const fs::path path = fs::path(scene.params.scene.name).replace_extension(".cam");
    if (!fs::exists(path)) continue;
    RenderParams params = scene.params;
    params.scene.camera_path = path.string();
    const int all = load_scene_of(ResolvedJob(params), context).scene.timeline.frame_count;
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
  return result;
}

}  // namespace lippmann::bench
