#include "render/params.hpp"

#include <filesystem>

#include "render/test_pattern.hpp"
#include "scene/builtin.hpp"

namespace lippmann {

bool is_builtin_scene(const std::string& scene) {
  if (scene == kTestPattern) return true;
  for (const BuiltinScene& builtin : builtin_scenes())
    if (builtin.name == scene) return true;
  return false;
}

Scene wanted_scene(const RenderParams& params, const Context& context) {
  if (params.scene == kTestPattern) return test_pattern_scene();
  LoadOptions options;
  if (!params.camera_path.empty()) options.camera_path = params.camera_path;
  options.frames_per_second = params.fps;
  options.animation = params.animation;
  return load_scene(params.scene, options, context);
}

std::string output_folder(const RenderParams& params) {
  if (!params.output.empty()) return params.output;
  return (std::filesystem::path("out") / std::filesystem::path(params.scene).stem()).string();
}

}  // namespace lippmann
