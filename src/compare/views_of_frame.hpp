// Reads the views of one frame in any format, as 8-bit samples.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

/// Describes a light field for which neither the file name nor a report.json states the arrangement. Uses the same options as
/// `convert`.
struct ViewsHints {
  std::string from = {};  ///< name of the format; empty if unknown
  std::optional<ViewGrid> views = {}, tiles = {};
};

struct FrameViews {
  ViewGrid grid;
  Vec2i view_size{0, 0};
  std::vector<Image8> views;
  /// Motion of the views, stacked like their pixels. nullopt if it was not requested, or if there is no motion layer.
  std::optional<Image> motion = {};
  /// Name of the format as in layout/formats.hpp. Empty for an image of a single view.
  std::string_view format = {};
};

/// Reads an image or a folder of views. Throws Error like open_light_field().
FrameViews read_views_of_frame(const std::filesystem::path& path, const ViewsHints& hints, bool with_motion,
                               const std::function<void(std::string_view)>& warn);

/// Reads the frame that is compared with a reference. If neither its name nor a report describes it, it is read like the
/// reference.
FrameViews read_views_like(const FrameViews& reference, const std::filesystem::path& path, const ViewsHints& hints,
                           const std::function<void(std::string_view)>& warn);

}  // namespace lippmann
