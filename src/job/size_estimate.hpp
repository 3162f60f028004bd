// How large the files of a render are likely to be, before anything is rendered: from what such files have taken per pixel.
//
// An estimate, within a factor of about two for scenes that fill the picture; a small thing before plain surroundings takes a
// fifth. Once a frame is written, its files say more.
#pragma once

#include <string>

#include "job/animation.hpp"
#include "job/params.hpp"

namespace lippmann {

/// Bytes of all frames.
struct FileSizes {
  double pictures = 0.0, layers = 0.0, videos = 0.0;
  double all() const { return pictures + layers + videos; }
};

/// The sizes of the frames of a plan, kept ones included.
FileSizes estimated_file_sizes(const RenderPlan& plan, const RenderParams& params);

/// "0.35 MB", "12 MB", "4.1 GB": two digits that count.
std::string bytes_text(double bytes);

}  // namespace lippmann
