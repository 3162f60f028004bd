// The files of one frame: names, and writing the picture with its extra layers.
#pragma once

#include <filesystem>

#include "image/encoding.hpp"
#include "image/image.hpp"
#include "render/params.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {

/// DIR/frame_0000.png or .exr.
std::filesystem::path picture_path(const std::filesystem::path& folder, int frame, PictureFormat format);

/// DIR/aov_0000.exr: where the extra layers go when the pictures are not EXR.
std::filesystem::path aov_path(const std::filesystem::path& folder, int frame);

struct FramePictures {
  Image film;
  FrameAovs aovs;
  Image8 codes;  ///< of the film: what PNG and videos hold; empty where nothing asked for them
};

/// Which of the extra layers tracing has to fill.
FrameAovs wanted_aovs(const RenderParams& params);

/// Writes what `params` asks for, each file whole or not at all. Throws Error naming the file.
void write_frame_files(const std::filesystem::path& folder, int frame, const RenderParams& params, Encoding encoding,
                       const FramePictures& pictures);

}  // namespace lippmann
