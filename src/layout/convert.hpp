// Turns pictures that hold the views of a light field into one another: integral images, quilts, one picture per view. Pixels
// are moved, never changed, so that every way and back is exact.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "layout/view_layout.hpp"

namespace lippmann {

struct ConvertParams {
  LayoutKind from = LayoutKind::kIntegral, to = LayoutKind::kStack;  ///< kStack: a folder of view_000.png ...
  std::optional<ViewGrid> views;  ///< needed for integral images; else as many as there are, in one row
  std::optional<ViewGrid> tiles;  ///< of a quilt; none: as its name says, or as square as can be
  std::optional<double> aspect;   ///< of the display, for a quilt's name; none: as the source's, or the picture's
};

struct Converted {
  std::vector<std::filesystem::path> written;
  ViewGrid views;
  Vec2i view_size{0, 0};
};

/// A picture, or a folder of frame_*.png of which each is converted (into frames, or folders of views), or the folder of views.
/// A quilt is written under its proper name (quilt_name.hpp). Throws Error naming the file or flag.
Converted convert(const std::filesystem::path& in, const std::filesystem::path& out, const ConvertParams& params);

}  // namespace lippmann
