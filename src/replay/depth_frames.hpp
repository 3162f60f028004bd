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
  std::filesystem::path in;    ///< an image, a folder of frame_*_rgbd.png, or a video
  std::filesystem::path out;   ///< as for convert (layout/convert.hpp)
  std::string to;              ///< a format
  FormatOptions options = {};  ///< views: their number; display: the display of the quilt or of the lenses; depth_range and its
                               ///< companions describe IN
  std::optional<double> view_angle_deg = {};  ///< without a display; none: the default for views with unknown cameras
  double ipd_mm = kDefaultIpdMm;              ///< for `to` stereo
  double depth_scale = 1.0;                   ///< shown depth / coded depth
  std::filesystem::path depth = {};           ///< depth map of the image IN (layout/depth_map.hpp); empty: IN is RGB-D
  bool is_pair = false;                       ///< IN is a stereo image, or a folder of them (replay/pair_depth.hpp)
};

struct ConvertedDepth {
  std::vector<std::filesystem::path> written;
  ViewGrid views;
  Vec2i view_size{0, 0};
  double filled_share = 0.0;  ///< share of all pixels that no pixel of IN covers and that are filled
};

/// Returns whether an image or video, or the first frame of a folder, is RGB-D by its name or side file.
bool is_rgbd(const std::filesystem::path& in);

/// Converts all frames. Integer samples keep their number of bits. Warns about the depth range assumed without a side file.
/// Throws Error naming the file or parameter.
ConvertedDepth convert_depth_frames(const DepthConversion& params, const Context& context);

}  // namespace lippmann
