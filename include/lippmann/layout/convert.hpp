// Turns light fields of one format into another. Pixels are moved, never changed, so that ways and back are exact wherever
// both formats hold the same samples; only pictures for a display are resampled (layout/display_picture.hpp).
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
  std::string from, to = "views";  ///< names of formats; `from` empty: as the name of a quilt or the report beside it says
  FormatOptions options;
  std::optional<Crop> crop;       ///< the part of every view that is kept; none: all of it
  std::optional<KeptViews> keep;  ///< the views that are kept, chosen before they are cropped; none: all
  /// Resample for options.display, whose picture `to` (integral, quilt or native) is; none: move pixels.
  std::optional<DisplayPictureParams> display_picture = {};
  /// Reads IN in place of a format's reader: a video, which no reader of layout knows (replay/video_views.hpp).
  std::function<LightField(const std::filesystem::path&, const FormatOptions&)> read_views = {};
  std::filesystem::path icc = {};  ///< profile of the printer, for display pictures that are prints; empty: they are sRGB
  int threads = 0;                 ///< of display pictures; 0: one per processor
};

struct Converted {
  std::vector<std::filesystem::path> written;
  ViewGrid views;
  Vec2i view_size{0, 0};
  bool drops_positions = false;                     ///< of cameras, without a unit or distance, which the format does not hold
  std::string fitted = {};                          ///< how views were resampled for a display; empty: they were not
  bool lacks_cameras = false, lacks_depth = false;  ///< which a format would have taken, but nothing gave
};

/// Where a report.json of `render` lies beside a picture, it says what its views are, unless the options say it; and for
/// formats that want them, what their cameras are, and the layer of depth comes with them.
///
/// `in`: a light field of that format, or a folder of frame_* (pictures or folders of views), of which each is converted, into
/// pictures or folders of the same names. A picture without an ending gets the one that suits its samples. A quilt is written
/// under its proper name (quilt_name.hpp). Throws Error naming the file or flag.
Converted convert(const std::filesystem::path& in, const std::filesystem::path& out, const ConvertParams& params);

}  // namespace lippmann
