// The plan of a render: folder, frames, sizes and memory, for progress displays and dry runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "job/job_stage.hpp"
#include "layout/frame_names.hpp"

namespace lippmann {

struct RenderPlan {
  const JobStage& stage;
  std::filesystem::path folder;
  FrameNames names;
  PictureFormat format = PictureFormat::kPng;
  std::vector<int> frames;               ///< ascending: those of the unit that is rendered, or all
  std::vector<std::string> videos = {};  ///< files
  int strips = 0;  ///< that `frames` are rendered in, those of the unit that is rendered; 0: they are rendered whole
  int kept = 0;    ///< how many of `frames`, or of their strips, the same job has finished before
  Vec2i picture_size{0, 0};
  int pictures_per_frame = 1;
  double memory_bytes = 0.0;  ///< that frames take beside the scene, about (memory_plan.hpp)
  int bands = 1;              ///< that frames are rendered in, as whole ones would take more memory than there is
  double join_bytes = 0.0;    ///< that joining a frame from strips takes, about; 0: none is joined
};

/// Bytes of all pictures of a plan before compression: more than what PNG and EXR files take. Layers and videos are not
/// counted; job/size_estimate.hpp says what files are likely to take.
std::uint64_t largest_picture_bytes(const RenderPlan& plan, ExrPixels exr_pixels);

}  // namespace lippmann
