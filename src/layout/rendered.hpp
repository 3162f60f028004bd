// What lies beside a picture that `render` wrote: report.json, which says what its optics were, and layers.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// What a report says of one frame.
struct FrameFacts {
  std::string kind = {};               ///< full, key or in-between; empty: the report does not say
  std::optional<double> psnr_db = {};  ///< as estimated while rendering; none: exact, or not estimated
};

struct Rendering {
  Optics optics;
  std::string layout = {};      ///< what `layout` or `to` asked for: integral, views, quilt, ...; empty: as their optics lie
  bool mirrored = false;        ///< left and right exchanged, to be printed on the back of a sheet
  bool has_depth_layer = true;  ///< else a layer of depth that lies there is of another render
  bool has_provenance = false;  ///< likewise
  std::optional<double> frames_per_second = {};
  float depth_scale = 1.0f;  ///< shown depth / true depth: the parallax that the pictures were rendered with
  std::map<int, FrameFacts> frames = {};
};

/// What a report says of it; none where it does not, or nothing within reason.
std::optional<double> frame_rate_of(const nlohmann::ordered_json& report);

/// What a report says. Throws Error naming it if it cannot be understood or does not say for which optics it is.
Rendering read_rendering(const std::filesystem::path& report);

/// Reads the report.json in the folder of the picture (or folder of views), or in that folder's own; none if there is none.
/// Throws Error naming the report if it cannot be understood.
std::optional<Rendering> rendering_of(const std::filesystem::path& picture);

/// What a report says, for pictures that can be shown without it: none if there is no report, or if it is damaged.
std::optional<Rendering> readable_rendering(const std::filesystem::path& report);

/// Warns if a picture or folder is of a render whose journal is gone or does not name some of its files: they cannot be checked
/// for damage (core/recorded_file.hpp).
void warn_of_unchecked(const std::filesystem::path& in, const Context& context);

/// z in display mm, one channel, of the picture's size: of an EXR picture that has it, or of aov_0000.exr beside frame_0000...,
/// aov_000.exr beside view_000... None if there is none. Throws Error as read_channels.
std::optional<Image> rendered_depth(const std::filesystem::path& picture);

/// Likewise, by how many pixels of its view each point has moved since the frame before: two channels, right and down.
std::optional<Image> rendered_motion(const std::filesystem::path& picture);

/// Likewise, where its pixels came from: values of Provenance (lippmann/trace/aovs.hpp).
std::optional<Image> rendered_provenance(const std::filesystem::path& picture);

}  // namespace lippmann
