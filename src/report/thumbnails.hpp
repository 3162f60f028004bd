// Thumbnails of some frames of a render. Each shows the middle view, as an eye in front of the display sees it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

struct Thumbnail {
  std::string label;    ///< label of the frame, from its file name
  std::string source;   ///< the image as a data: URL
  double aspect = 1.0;  ///< width / height as displayed; pixels may be non-square
};

struct Thumbnails {
  std::vector<Thumbnail> pictures;
  std::string problem;  ///< sentence that states why images are missing; empty: none is missing
};

/// Returns thumbnails of at most `most` frames, evenly spaced including the first and the last. Reads the frames from the
/// folder of the report. Sets `problem` if some of them cannot be read.
Thumbnails read_thumbnails(const std::filesystem::path& report, std::size_t most, const Context& context);

}  // namespace lippmann
