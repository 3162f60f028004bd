#pragma once

#include "lippmann/frames/frame_report.hpp"

namespace lippmann::test {

inline FrameReport sample_frame() {
  FrameReport frame;
  frame.frame = 7;
  frame.seconds = 0.5;
  frame.cpu_seconds = 0.75;
  frame.rays = {100, 200, 30, 4};
  frame.estimated_psnr_db = 48.5;
  return frame;
}

}  // namespace lippmann::test
