#include "job/params.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "job/test_pattern.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/builtin.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {

bool is_builtin_scene(const std::string& scene) {
  if (scene == kTestPattern) return true;
  for (const BuiltinScene& builtin : builtin_scenes())
    if (builtin.name == scene) return true;
  return false;
}

bool wants_stereo(const RenderParams& params) {
  const PictureParams& pictures = params.output.pictures;
  return pictures.layout == PictureLayout::kStereo || pictures.to == "stereo";
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
