// A frame as it was traced: its film and layers as the optics lie, and what making it took.
#pragma once

#include "lippmann/frames/frame_report.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/trace/aovs.hpp"

namespace lippmann {

struct FramePictures {
  Image film;
  FrameAovs aovs;
  Image8 codes;  ///< the film's 8-bit codes, for files and videos; empty where nothing needs them
};

/// A frame as traced, and what that took. The codes are not made yet.
struct RenderedFrame {
  FramePictures pictures;
  FrameReport report;
};

}  // namespace lippmann
