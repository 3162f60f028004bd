// A rendered frame with its layers and its report.
#pragma once

#include "lippmann/frames/frame_report.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/trace/aovs.hpp"

namespace lippmann {

/// All images are in the native layout of the optics.
struct FramePictures {
  Image film{};      ///< linear light, RGB
  FrameAovs aovs{};  ///< extra layers, such as depth
  Image8 codes{};    ///< 8-bit codes of the film; empty if not needed
};

/// A frame and its report. The renderer leaves pictures.codes empty.
struct RenderedFrame {
  FramePictures pictures{};
  FrameReport report{};
};

}  // namespace lippmann
