// A rendered frame: its film and layers in the native layout of the optics, and its report.
#pragma once

#include "lippmann/frames/frame_report.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/trace/aovs.hpp"

namespace lippmann {

/// The images of one frame, all in the native layout of the optics.
struct FramePictures {
  Image film{};      ///< linear light, RGB
  FrameAovs aovs{};  ///< the extra layers
  Image8 codes{};    ///< 8-bit codes of the film for files and videos; empty if not needed
};

/// A frame and its report. pictures.codes is left empty.
struct RenderedFrame {
  FramePictures pictures{};
  FrameReport report{};
};

}  // namespace lippmann
