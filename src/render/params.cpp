#include "render/params.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "render/environment_file.hpp"
#include "render/test_pattern.hpp"
#include "scene/builtin.hpp"
#include "scene/default_light.hpp"

namespace lippmann {

bool is_builtin_scene(const std::string& scene) {
  if (scene == kTestPattern) return true;
  for (const BuiltinScene& builtin : builtin_scenes())
    if (builtin.name == scene) return true;
  return false;
}

std::vector<int> frames_of(const FrameRanges& ranges) {
  std::vector<int> frames;
  for (const FrameRange& range : ranges)
    for (std::int64_t frame = range.first; frame <= range.last; frame += range.step) frames.push_back(static_cast<int>(frame));
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

Scene wanted_scene(const RenderParams& params, const Context& context, std::vector<std::string>* names) {
  if (params.scene == kTestPattern) return test_pattern_scene();
  LoadOptions options;
  if (!params.camera_path.empty()) options.camera_path = params.camera_path;
  options.frames_per_second = params.fps;
  options.animation = params.animation;
  options.asset_root = params.asset_root;
  Scene scene = load_scene(params.scene, options, context);
  if (names) *names = camera_names(scene);
  choose_camera(scene, params.camera);
  turn_upright(scene, params.up);
  for (Light& light : scene.lights) light.color *= params.light_scale;
  if (!params.environment.empty()) {
    scene.background.map = read_environment(params.environment, params.environment_strength, params.environment_rotation_deg);
  } else if (lacks_light(scene, params.integrator == Integrator::kPath)) {
    context.warning(fmt::format("{} has no lights: a key light from above left of the viewer and a dim background are added",
                                params.scene));
    add_default_light(scene);
  }
  return scene;
}

std::string output_folder(const RenderParams& params) {
  if (!params.output.empty()) return params.output;
  return (std::filesystem::path("out") / std::filesystem::path(params.scene).stem()).string();
}

}  // namespace lippmann
