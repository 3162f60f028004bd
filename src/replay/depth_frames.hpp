// Converts RGB-D images and videos to light fields in any format: views for a display, or a stereo pair
// (replay/depth_views.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

struct DepthConversion {
  std::filesystem::path in;   ///< input: an image, a folder of frame_*_rgbd.png, or a video
  std::filesystem::path out;  ///< output, as for convert (layout/convert.hpp)
  std::string to;             ///< name of the output format
  /// Uses `views` (number of views), `display` (quilt or lenses), `depth_range` and related options (depth of `in`).
  FormatOptions options = {};
  /// Full angle of the views if there is no display; none: the default for views with unknown cameras.
  std::optional<double> view_angle_deg = {};
  double ipd_mm = kDefaultIpdMm;     ///< distance between the eyes, for the format stereo
  double depth_scale = 1.0;          ///< factor of depth: depth shown / depth stored in the image
  std::filesystem::path depth = {};  ///< depth map of the image `in` (layout/depth_map.hpp); empty: `in` is RGB-D
  bool is_pair = false;              ///< whether `in` is a stereo image, or a folder of stereo images (replay/pair_depth.hpp)
};

struct ConvertedDepth {
  std::vector<std::filesystem::path> written;
  ViewGrid views;
  Vec2i view_size{0, 0};
  /// Share of all output pixels that no pixel of `in` covers, so that they were filled from neighbours.
  double filled_share = 0.0;
};

/// Returns whether an image, a video or the first frame of a folder is RGB-D, according to its name or side file.
bool is_rgbd(const std::filesystem::path& in);

/// Converts all frames. Integer samples keep their number of bits. Warns about the depth range that is assumed without a side
/// file. Throws Error naming the file or parameter.
ConvertedDepth convert_depth_frames(const DepthConversion& params, const Context& context);

}  // namespace lippmann
