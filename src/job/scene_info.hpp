// Describes a scene: its content, its animation, the fitted array, and the depth that the array can show.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "job/job_scene.hpp"
#include "job/resolved_job.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

struct SceneInfo {
  std::string name;
  std::size_t nodes = 0, instances = 0, meshes = 0, triangles = 0;
  std::size_t spheres = 0, cylinders = 0, planes = 0, rings = 0, boxes = 0, splats = 0;
  std::size_t materials = 0, textures = 0, lights = 0, cameras = 0;

  SceneNotes notes;

  int frames = 1;
  double frames_per_second = 25.0;
  bool keys_on_frames = true;        ///< every key of the animation falls on a frame
  std::size_t moving_instances = 0;  ///< instances that move or change their shape
  std::vector<std::string> animations;
  int animation = -1;  ///< the shown animation; -1: none
  std::vector<std::string> variants;

  /// Origin of `bounds` and `array_center`, in the coordinates of the file.
  Vec3d origin{0.0};
  /// Bounds of all finite shapes over the animation, sampled at up to 32 frames, in world coordinates.
  Bounds3f bounds;

  FittedArray array;
  Optics optics;
  float units_per_mm = 1.0f, depth_scale = 1.0f;  ///< see PlacedOptics
  /// Centre of the lens array at the first frame, in world coordinates.
  Vec3f array_center{0.0f};
  std::vector<std::string> warnings;  ///< contents of the file that the importer left out
};

/// Loads the scene and places the optics as a render would. Throws Error.
SceneInfo describe_scene(const ResolvedJob& job, const Context& context);

nlohmann::ordered_json to_json(const SceneInfo& info);

std::string to_text(const SceneInfo& info);

}  // namespace lippmann
