#include "render/params.hpp"

#include <filesystem>

#include "scene/builtin.hpp"

namespace lippmann {

bool is_builtin_scene(const std::string& scene) {
  for (const BuiltinScene& builtin : builtin_scenes())
    if (builtin.name == scene) return true;
  return false;
}

std::string output_folder(const RenderParams& params) {
  if (!params.output.empty()) return params.output;
  return (std::filesystem::path("out") / std::filesystem::path(params.scene).stem()).string();
}

}  // namespace lippmann
