// Thumbnails of some frames of a render: the middle view of each, from the position of an eye in front of the display.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

struct Thumbnail {
  std::string label;    ///< label of the frame, from its file name
  std::string source;   ///< a data: URL
  double aspect = 1.0;  ///< displayed width / height; pixels may be non-square
};

struct Thumbnails {
  std::vector<Thumbnail> pictures;
  std::string problem;  ///< why images are missing; empty: all are present
};

/// Returns thumbnails of at most `most` frames, evenly spaced including the first and the last, from the folder of a render's
/// report. Sets `problem` if some cannot be read.
Thumbnails read_thumbnails(const std::filesystem::path& report, std::size_t most, const Context& context);

}  // namespace lippmann
