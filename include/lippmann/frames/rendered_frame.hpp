// A frame as it was traced: its film and layers as the optics lie, and what making it took.
#pragma once

#include "lippmann/frames/frame_report.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/trace/aovs.hpp"

namespace lippmann {

struct FramePictures {
  Image film;
  FrameAovs aovs;
  Image8 codes;  ///< of the film: what 8-bit files and videos hold; empty where nothing asked for them
};

/// A frame as traced, and what that took. The codes are not made yet.
struct RenderedFrame {
  FramePictures pictures;
  FrameReport report;
};

}  // namespace lippmann
