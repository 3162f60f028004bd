// The plan of a render: folder, frames, sizes and memory. It is shown by progress displays and dry runs.
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
  /// Frames of the requested units, or of the whole job, in ascending order.
  std::vector<int> frames;
  std::vector<std::string> videos = {};
  /// Number of strips to render. 0 if whole frames are rendered.
  int strips = 0;
  int kept = 0;  ///< number of frames (or strips) that are kept from earlier runs
  Vec2i picture_size{0, 0};
  int pictures_per_frame = 1;
  double memory_bytes = 0.0;  ///< estimated memory of frames, without the scene (memory_plan.hpp)
  int bands = 1;              ///< number of bands per frame; above 1 only if memory is short
  /// Estimated memory for joining a frame from strips. 0 if no frame is joined.
  double join_bytes = 0.0;
  bool is_light_field = false;  ///< whether frames have a light-field format, which also stores their layers
};

/// Returns the size of all pictures of a plan before compression, in bytes. It is an upper limit for PNG and EXR files. Layers
/// and videos are not included. job/size_estimate.hpp estimates the sizes of compressed files.
std::uint64_t largest_picture_bytes(const RenderPlan& plan, ExrPixels exr_pixels);

}  // namespace lippmann
