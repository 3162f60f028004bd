// Converts light fields between formats. Pixels are moved, not changed, except in pictures for a display
// (layout/display_picture.hpp).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/display_picture.hpp"
#include "lippmann/layout/subset.hpp"

namespace lippmann {

struct ConvertParams {
  /// Names of formats. If `from` is empty, the format is detected from a quilt's file name or the report beside the input.
  std::string from{}, to = "views";
  FormatOptions options{};
  std::optional<Crop> crop{};       ///< part of every view to keep; none: whole views
  std::optional<KeptViews> keep{};  ///< views to keep, chosen before cropping; none: all
  /// Resamples the views for options.display. `to` must then be integral, quilt or native. None: pixels are moved, not
  /// resampled.
  std::optional<DisplayPictureParams> display_picture = {};
  /// Reads the input instead of the format's reader. Used for video (replay/video_views.hpp).
  std::function<LightField(const std::filesystem::path&, const FormatOptions&)> read_views = {};
  std::filesystem::path icc = {};  ///< printer's colour profile, for prints; empty: sRGB
  int threads = 0;                 ///< for display pictures; 0: one per processor
};

struct Converted {
  std::vector<std::filesystem::path> written{};
  ViewGrid views{};
  Vec2i view_size{0, 0};
  std::vector<std::string> left_out = {};  ///< data that the output format cannot store (kept_data.hpp), such as "12 points"
  std::string fitted = {};                 ///< how views were resampled for a display; empty: not resampled
  std::string too_coarse = {};             ///< result of ViewFitter::coarseness()
  /// True: the output format has files for cameras or depth, which are not written because the input has none.
  bool lacks_cameras = false, lacks_depth = false;
};

/// Converts the light field `in` to `out`. Frames frame_* of a folder (pictures or folders of views) keep their names. A
/// report.json of `render` supplies values that the options leave empty.
///
/// A picture name without an ending gets one that suits the samples. A quilt is written with its view layout in the name
/// (quilt_name.hpp). Throws Error naming the file or option.
Converted convert(const std::filesystem::path& in, const std::filesystem::path& out, const ConvertParams& params);

}  // namespace lippmann
