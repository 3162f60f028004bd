// Thumbnails of some frames of a render, which show the middle view as an eye in front of the display sees it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

struct Thumbnail {
  std::string label;
  std::string source;   ///< image as a data: URL
  double aspect = 1.0;  ///< width / height as displayed; pixels need not be square
};

struct Thumbnails {
  std::vector<Thumbnail> pictures;
  std::string problem;
};

/// Returns at most `most` frames, evenly spaced from the first to the last, from the folder of the report. Sets `problem` if
/// some cannot be read.
Thumbnails read_thumbnails(const std::filesystem::path& report, std::size_t most, const Context& context);

}  // namespace lippmann
