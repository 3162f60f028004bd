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

/// Describes a light field whose layout neither the file name nor a report.json states.
struct ViewsHints {
  std::string from = {};
  std::optional<ViewGrid> views = {}, tiles = {};
};

struct FrameViews {
  ViewGrid grid;
  Vec2i view_size{0, 0};
  std::vector<Image8> views;
  /// Motion of the views, stacked like their pixels. nullopt if not requested or not there.
  std::optional<Image> motion = {};
  /// Name of the frame's format in formats/formats.hpp; empty for a single view.
  std::string_view format = {};
};

/// Returns whether the path is a light field, or a folder of light fields or of rendered views, whose layout a file states.
bool states_views(const std::filesystem::path& path);

FrameViews read_views_of_frame(const std::filesystem::path& path, const ViewsHints& hints, bool with_motion,
                               const std::function<void(std::string_view)>& warn);

/// Reads a frame to compare with `reference`. If neither the file name nor a report gives its layout, assumes the layout of the
/// reference.
FrameViews read_views_like(const FrameViews& reference, const std::filesystem::path& path, const ViewsHints& hints,
                           const std::function<void(std::string_view)>& warn);

}  // namespace lippmann
