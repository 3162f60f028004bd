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
  std::vector<int> frames;               ///< the frames of this unit, or of the whole job; ascending
  std::vector<std::string> videos = {};  ///< the files of the videos
  int strips = 0;                        ///< number of strips of `frames` to render in this unit; 0: whole frames are rendered
  int kept = 0;                          ///< number of `frames`, or of their strips, that are kept from earlier runs
  Vec2i picture_size{0, 0};
  int pictures_per_frame = 1;
  double memory_bytes = 0.0;  ///< estimated memory for frames, without the scene (memory_plan.hpp)
  int bands = 1;              ///< bands per frame; more than 1 only if memory is short
  double join_bytes = 0.0;    ///< estimated memory for joining a frame from strips; 0: no frame is joined
};

/// Returns the bytes of all pictures of a plan before compression, an upper bound for PNG and EXR files. Layers and videos are
/// not included. job/size_estimate.hpp estimates the sizes of the compressed files.
std::uint64_t largest_picture_bytes(const RenderPlan& plan, ExrPixels exr_pixels);

}  // namespace lippmann
