// RGB-D pictures and videos shown as light fields: views for a display, or two eyes' views, in any format
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
  std::filesystem::path in;    ///< a picture, a folder of frame_*_rgbd.png, or a video
  std::filesystem::path out;   ///< as of convert (layout/convert.hpp)
  std::string to;              ///< a format
  FormatOptions options = {};  ///< views: how many; display: whose quilt they are, or whose lenses show them; depth_range and
                               ///< what is with it: of IN
  std::optional<double> view_angle_deg = {};  ///< without a display; none: as of views that nothing describes
  double ipd_mm = kUsualIpdMm;                ///< `to` stereo
  double depth_scale = 1.0;                   ///< shown depth / coded depth
  std::filesystem::path depth = {};           ///< the depth of the picture IN (layout/depth_map.hpp); empty: IN is RGB-D
  bool is_pair = false;                       ///< IN is a stereo picture, or a folder of them (replay/pair_depth.hpp)
};

struct ConvertedDepth {
  std::vector<std::filesystem::path> written;
  ViewGrid views;
  Vec2i view_size{0, 0};
  double filled_share = 0.0;  ///< the share of all pixels that show nothing of the picture and are filled
};

/// Whether a picture or video, or the first of a folder's frames, is RGB-D by its name or side file.
bool is_rgbd(const std::filesystem::path& in);

/// Codes stay codes of as many bits. Says what is assumed of pictures without a side file. Throws Error naming the file or
/// parameter.
ConvertedDepth convert_depth_frames(const DepthConversion& params, const Context& context);

}  // namespace lippmann
