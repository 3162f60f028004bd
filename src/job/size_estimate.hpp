// Estimates the size of a render's files before rendering, from measured bytes per pixel. The estimate is accurate to a factor
// of about two if the scene fills the picture. For a small object in front of a plain background, files have about a fifth of
// the estimated size.
#pragma once

#include <string>

#include "job/animation.hpp"
#include "job/params.hpp"

namespace lippmann {

/// Total sizes of the files of all frames, in bytes.
struct FileSizes {
  double pictures = 0.0, layers = 0.0, videos = 0.0;
  double all() const { return pictures + layers + videos; }
};

/// Returns the sizes for all frames of the plan, including frames kept from earlier runs.
FileSizes estimated_file_sizes(const RenderPlan& plan, const RenderParams& params);

/// Returns the size with two significant digits, such as "0.35 MB", "12 MB" or "4.1 GB".
std::string bytes_text(double bytes);

}  // namespace lippmann
