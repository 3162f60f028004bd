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
  double aspect = 1.0;  ///< width / height as displayed; pixels need not be square
};

struct Thumbnails {
  std::vector<Thumbnail> pictures;
  /// Sentence that states why images are missing. Empty if none is missing.
  std::string problem;
};

/// Returns thumbnails of at most `most` frames. The frames are evenly spaced and include the first and the last frame. Reads
/// the frames from the folder of the report. Sets `problem` if some frames cannot be read.
Thumbnails read_thumbnails(const std::filesystem::path& report, std::size_t most, const Context& context);

}  // namespace lippmann
