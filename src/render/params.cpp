#include "render/params.hpp"

#include <filesystem>

#include "scene/builtin.hpp"

namespace lippmann {

bool is_builtin_scene(const std::string& scene) {
  for (const BuiltinScene& builtin : builtin_scenes())
    if (builtin.name == scene) return true;
  return false;
}

LoadOptions load_options(const RenderParams& params) {
  LoadOptions options;
  if (!params.camera_path.empty()) options.camera_path = params.camera_path;
  options.frames_per_second = params.fps;
  return options;
}

std::string output_folder(const RenderParams& params) {
  if (!params.output.empty()) return params.output;
  return (std::filesystem::path("out") / std::filesystem::path(params.scene).stem()).string();
}

}  // namespace lippmann
