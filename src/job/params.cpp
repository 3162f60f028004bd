#include "job/params.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "job/scene_light.hpp"
#include "job/test_pattern.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/formats.hpp"
#include "lippmann/scene/builtin.hpp"

namespace lippmann {

namespace {

/// Samples a pixel of splats: nothing else smooths what is smaller than a pixel.
constexpr int kSplatSamples = 4;

}  // namespace

bool is_builtin_scene(const std::string& scene) {
  if (scene == kTestPattern) return true;
  for (const BuiltinScene& builtin : builtin_scenes())
    if (builtin.name == scene) return true;
  return false;
}

RenderParams with_scene_defaults(RenderParams params) {
  PictureParams& pictures = params.output.pictures;
  if (pictures.layout == PictureLayout::kRgbd && pictures.to.empty()) pictures.layout.reset(), pictures.to = "rgbd";
  if (pictures.to == "rgbd" && !params.optics.kind) params.optics.kind = OpticsKind::kSingle;  // the view that is written
  const std::string& format = params.output.pictures.to;
  std::vector<Aov>& layers = params.sampling.aov;
  if (!format.empty() && find_format(format, "to").uses_cameras &&
      std::find(layers.begin(), layers.end(), Aov::kDepth) == layers.end())
    layers.push_back(Aov::kDepth);
  if (params.sampling.integrator) return params;
  // Splats are light already: no path finds more.
  const bool of_splats = is_physical_format(params.scene.name) && is_splat_file(params.scene.name);
  const bool paths = is_physical_format(params.scene.name) && !of_splats && params.reuse.choice != ReuseChoice::kInterpolate;
  if (of_splats && params.sampling.spp == 0) params.sampling.spp = kSplatSamples;
  params.sampling.integrator = paths ? Integrator::kPath : Integrator::kWhitted;
  return params;
}

bool wants_stereo(const RenderParams& params) {
  const PictureParams& pictures = params.output.pictures;
  return pictures.layout == PictureLayout::kStereo || pictures.to == "stereo";
}

bool fits_depth(const RenderParams& params) {
  return params.optics.fit_depth.value_or(!params.optics.display.empty() || optics_kind(params) != OpticsKind::kMultiview);
}

Scene wanted_scene(const RenderParams& params, const Context& context, SceneNotes* notes) {
  if (params.scene.name == kTestPattern) return test_pattern_scene();
  LoadOptions options;
  if (!params.scene.camera_path.empty()) options.camera_path = params.scene.camera_path;
  options.frames_per_second = params.scene.fps;
  options.animation = params.scene.animation;
  options.variant = params.scene.variant;
  options.asset_root = params.scene.asset_root;
  options.texture_bytes = static_cast<std::uint64_t>(params.scene.texture_memory) << 20;
  Scene scene = load_scene(params.scene.name, options, context);
  SceneNotes known{camera_names(scene), {}};
  choose_camera(scene, params.scene.camera);
  turn_upright(scene, params.scene.up);
  for (Light& light : scene.lights) light.color *= params.scene.light_scale;
  known.light = light_scene(scene, params, context);
  if (notes) *notes = std::move(known);
  return scene;
}

std::string output_folder(const RenderParams& params) {
  if (!params.output.folder.empty()) return params.output.folder;
  return (std::filesystem::path("out") / std::filesystem::path(params.scene.name).stem()).string();
}

std::vector<int> frames_of_job(const RenderParams& params, const Timeline& timeline) {
  const int last = timeline.frame_count - 1;
  const FrameRanges ranges = params.output.frames.value_or(FrameRanges{{0, last}});
  for (const FrameRange& range : ranges)
    if (range.last > last)
      throw usage_error("frames", fmt::format("{} is outside the animation", write_frames({range})),
                        fmt::format("frames from 0 to {}", last));
  return frames_of(ranges);
}

}  // namespace lippmann
