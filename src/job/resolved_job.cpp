#include "job/resolved_job.hpp"

#include <algorithm>
#include <utility>

#include "job/camera_set_files.hpp"
#include "job/test_pattern.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/kept_data.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {
namespace {

void complete_pictures(RenderParams& params) {
  complete_camera_set(params);
  PictureParams& pictures = params.output.pictures;
  if (pictures.layout == PictureLayout::kRgbd && pictures.to.empty()) pictures.layout.reset(), pictures.to = "rgbd";
  if (pictures.to == "rgbd" && !params.optics.kind) params.optics.kind = OpticsKind::kSingle;  // RGB-D pictures have one view
  std::vector<Aov>& layers = params.sampling.aov;
  if (!pictures.to.empty() && uses_depth(find_output_format(pictures.to, "to").name) &&
      std::find(layers.begin(), layers.end(), Aov::kDepth) == layers.end())
    layers.push_back(Aov::kDepth);
}

}  // namespace

ResolvedJob::ResolvedJob(RenderParams asked) : params_(std::move(asked)) {
  complete_pictures(params_);
  if (params_.sampling.integrator) return;  // avoids opening the scene's file in scene_kind()
  const bool interpolates = params_.reuse.choice == ReuseChoice::kInterpolate;
  params_.sampling = completed(std::move(params_.sampling), scene_kind(params_.scene.name), interpolates);
}

bool ResolvedJob::is_test_pattern() const { return params_.scene.name == kTestPattern; }

int ResolvedJob::threads(const Context& context) const {
  return params_.threads > 0 ? params_.threads : resolved_threads(context);
}

double ResolvedJob::frames_per_second(const Timeline& timeline) const {
  return params_.scene.fps > 0.0 ? params_.scene.fps : timeline.frames_per_second;
}

ResolvedJob ResolvedJob::in_folder(const std::filesystem::path& folder) const {
  ResolvedJob same = *this;
  same.params_.output.folder = folder.string();
  return same;
}

}  // namespace lippmann
