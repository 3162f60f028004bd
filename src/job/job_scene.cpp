#include "job/job_scene.hpp"

#include <cstdint>

#include "job/scene_light.hpp"
#include "job/test_pattern.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/stage/camera_set.hpp"
#include "lippmann/stage/choose_camera.hpp"

namespace lippmann {
namespace {

LoadOptions load_options(const SceneParams& params) {
  LoadOptions options;
  if (!params.camera_path.empty()) options.camera_path = params.camera_path;
  options.frames_per_second = params.fps;
  options.animation = params.animation;
  options.variant = params.variant;
  options.asset_root = params.asset_root;
  options.texture_bytes = static_cast<std::uint64_t>(params.texture_memory) << 20;
  options.point_size = params.point_size.value_or(0.0);
  return options;
}

}  // namespace

JobScene load_scene_of(const ResolvedJob& job, const Context& context) {
  if (job.is_test_pattern()) return {test_pattern_scene(), {}};
  const SceneParams& params = job.scene();
  JobScene loaded{load_scene(params.name, load_options(params), context), {}};
  Scene& scene = loaded.scene;
  loaded.notes.camera_names = camera_names(scene);
  choose_camera(scene, params.camera);
  turn_upright(scene, params.up);
  if (params.cameras) surround_with_cameras(scene, *params.cameras);
  for (Light& light : scene.lights) light.color *= params.light_scale;
  loaded.notes.light = light_scene(scene, params, *job.sampling().integrator, context);
  return loaded;
}

}  // namespace lippmann
