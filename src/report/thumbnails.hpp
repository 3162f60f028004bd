// Small pictures of some frames of a render: the view in the middle of each, as an eye before the display sees it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann {

struct Thumbnail {
  std::string label;    ///< the frame's, as its file has it
  std::string source;   ///< a data: address
  double aspect = 1.0;  ///< width / height as it is to be shown; pixels may be oblong
};

struct Thumbnails {
  std::vector<Thumbnail> pictures;
  std::string problem;  ///< why there are none, or not all; empty: all are there
};

/// Of the folder in which a render's report lies: at most `most` frames, spread evenly, the first and the last among them. What
/// cannot be read is told.
Thumbnails read_thumbnails(const std::filesystem::path& report, std::size_t most, const Context& context);

}  // namespace lippmann
