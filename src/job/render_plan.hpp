// The plan of a render: folder, frames, sizes and memory. It is shown by progress displays and dry runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "formats/frame_names.hpp"
#include "job/job_stage.hpp"

namespace lippmann {

struct RenderPlan {
  const JobStage& stage;
  std::filesystem::path folder;
  FrameNames names;
  PictureFormat format = PictureFormat::kPng;
  /// Frames of the requested units, or of the whole job, in ascending order.
  std::vector<int> frames;
  std::vector<std::string> videos = {};
  /// Strips to render; 0: whole frames.
  int strips = 0;
  int kept = 0;  ///< frames (or strips) that are kept from earlier runs
  Vec2i picture_size{0, 0};
  int pictures_per_frame = 1;
  double memory_bytes = 0.0;  ///< estimated memory of frames, without the scene (memory_plan.hpp)
  int bands = 1;              ///< bands per frame; above 1 only if memory is short
  /// Estimated memory for joining a frame from strips; 0: no frame is joined.
  double join_bytes = 0.0;
  bool is_light_field = false;  ///< whether frames have a light-field format, which also stores their layers
};

/// Size of all pictures in bytes before compression, without layers and videos: an upper limit for PNG and EXR files.
std::uint64_t largest_picture_bytes(const RenderPlan& plan, ExrPixels exr_pixels);

}  // namespace lippmann
