// The views of one frame as codes, of whatever format the frame is.
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

/// Describes a light field if neither its name nor a report.json does, as for `convert`.
struct ViewsHints {
  std::string from = {};  ///< a format's name
  std::optional<ViewGrid> views = {}, tiles = {};
};

struct FrameViews {
  ViewGrid grid;
  Vec2i view_size{0, 0};
  std::vector<Image8> views;
  std::optional<Image> motion = {};  ///< a stack of the views; none: not wanted, or there is no such layer
  std::string_view format = {};      ///< as in layout/formats.hpp; empty: a picture of a single view
};

/// Reads a picture or a folder of views. Throws Error as open_light_field.
FrameViews read_views_of_frame(const std::filesystem::path& path, const ViewsHints& hints, bool with_motion,
                               const std::function<void(std::string_view)>& warn);

/// The same of the test of a reference: where nothing says what the test is, it is what the reference is.
FrameViews read_views_like(const FrameViews& reference, const std::filesystem::path& path, const ViewsHints& hints,
                           const std::function<void(std::string_view)>& warn);

}  // namespace lippmann
