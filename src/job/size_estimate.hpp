// Estimates the size of a render's files before rendering, from measured bytes per pixel.
//
// For scenes that fill the picture, the estimate is accurate to a factor of about two. A small object in front of a plain
// background takes only a fifth of the estimate. Once a frame is written, the sizes of its files give a better estimate.
#pragma once

#include <string>

#include "job/animation.hpp"
#include "job/params.hpp"

namespace lippmann {

/// Estimated sizes of the files of all frames, in bytes.
struct FileSizes {
  double pictures = 0.0, layers = 0.0, videos = 0.0;
  double all() const { return pictures + layers + videos; }
};

/// Returns the estimated sizes for all frames of a plan, including kept ones.
FileSizes estimated_file_sizes(const RenderPlan& plan, const RenderParams& params);

/// Returns "0.35 MB", "12 MB", "4.1 GB": two significant digits.
std::string bytes_text(double bytes);

}  // namespace lippmann
