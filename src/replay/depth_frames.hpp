// Converts RGB-D images and videos to light fields in any format: views for a display, or a stereo pair
// (replay/depth_views.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {

struct DepthConversion {
  std::filesystem::path in;
  std::filesystem::path out;
  std::string to;
  FormatOptions options = {};
  /// Full angle between the outermost views if there is no display. No value: the default of the layout.
  std::optional<double> view_angle_deg = {};
  double ipd_mm = kDefaultIpdMm;
  double depth_scale = 1.0;          ///< depth shown / depth stored in the image
  std::filesystem::path depth = {};  ///< depth map of the image `in` (formats/depth_map.hpp); empty if `in` is RGB-D
  bool is_pair = false;
};

struct ConvertedDepth {
  std::vector<std::filesystem::path> written;
  ViewGrid views;
  Vec2i view_size{0, 0};
  /// Fraction of the output pixels that had no point and were filled from neighbours.
  double filled_share = 0.0;
};

/// Returns whether the name or side file of an image, a video or a folder's first frame states that it is RGB-D.
bool is_rgbd(const std::filesystem::path& in);

/// Converts all frames. Integer samples keep their number of bits. Warns if the depth range is unknown and a default is used.
/// Throws Error naming the file or parameter.
ConvertedDepth convert_depth_frames(const DepthConversion& params, const Context& context);

}  // namespace lippmann
