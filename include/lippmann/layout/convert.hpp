// Converts light fields between formats. Pixels are moved, not changed, so a round trip is exact if both formats can store
// the samples. Only pictures for a display are resampled (layout/display_picture.hpp).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/layout/display_picture.hpp"
#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/subset.hpp"

namespace lippmann {

struct ConvertParams {
  /// Names of formats. If `from` is empty, the format is detected from a quilt's file name or the report beside the input.
  std::string from{}, to = "views";
  FormatOptions options{};
  std::optional<Crop> crop{};       ///< window of every view to keep; none: whole views
  std::optional<KeptViews> keep{};  ///< views to keep; they are chosen before cropping; none: all views
  /// Parameters for resampling the views for options.display. `to` must then be integral, quilt or native. None: pixels are
  /// moved, not resampled.
  std::optional<DisplayPictureParams> display_picture = {};
  /// Called instead of a format's reader to read the input. Used for video, which the layout part cannot read
  /// (replay/video_views.hpp).
  std::function<LightField(const std::filesystem::path&, const FormatOptions&)> read_views = {};
  std::filesystem::path icc = {};  ///< printer's colour profile, for display pictures that are prints; empty: prints are sRGB
  int threads = 0;                 ///< number of threads for display pictures; 0: one per processor
};

struct Converted {
  std::vector<std::filesystem::path> written{};
  ViewGrid views{};
  Vec2i view_size{0, 0};
  bool drops_positions = false;  ///< true: the output format cannot store the input's camera positions
  bool drops_poses = false;      ///< true: the output does not state the input's cameras, which share no plane and window
  std::string fitted = {};       ///< how views were resampled for a display; empty: not resampled
  bool lacks_cameras = false, lacks_depth = false;  ///< the format can store cameras or depth, but the input has none
};

/// Converts the light field `in` to `out`. If `in` is a folder of frame_* (pictures or folders of views), converts each of them
/// into a picture or folder of the same name in `out`. A report.json of `render` beside a picture supplies the numbers of views
/// that the options leave out and, for formats that use them, cameras and depth.
///
/// A picture name without an ending gets one that suits the samples. A quilt is written with its view layout in the name
/// (quilt_name.hpp). Throws Error naming the file or option.
Converted convert(const std::filesystem::path& in, const std::filesystem::path& out, const ConvertParams& params);

}  // namespace lippmann
