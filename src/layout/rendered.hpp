// Reads the files beside a picture that `render` wrote: report.json with its optics, and layers.
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

/// The report's information about one frame.
struct FrameFacts {
  std::string kind = {};               ///< full, key or in-between; empty: not in the report
  std::optional<double> psnr_db = {};  ///< as estimated during rendering; none: exact or not estimated
};

struct Rendering {
  Optics optics;
  std::string layout = {};  ///< the setting `layout` or `to`: integral, views, quilt, ...; empty: native layout of the optics
  bool mirrored = false;    ///< left and right swapped, for prints on the back of a sheet
  bool has_depth_layer = true;  ///< false: a depth layer in the folder belongs to another render
  bool has_provenance = false;  ///< false: a provenance layer in the folder belongs to another render
  std::optional<double> frames_per_second = {};
  float depth_scale = 1.0f;  ///< shown depth / true depth: the parallax used for rendering
  std::map<int, FrameFacts> frames = {};
};

/// Returns the frame rate in a report; none if it is missing or unreasonable.
std::optional<double> frame_rate_of(const nlohmann::ordered_json& report);

/// Reads a report. Throws Error naming it if it is malformed or has no optics.
Rendering read_rendering(const std::filesystem::path& report);

/// Reads the report.json in the folder of the picture (or folder of views), or in that folder's parent; none if there is none.
/// Throws Error naming the report if it is malformed.
std::optional<Rendering> rendering_of(const std::filesystem::path& picture);

/// Reads a report for pictures that can be shown without it; none if it is missing or malformed.
std::optional<Rendering> readable_rendering(const std::filesystem::path& report);

/// Warns if a picture or folder belongs to a render whose journal is missing or does not list some of its files, which
/// therefore cannot be checked for damage (core/recorded_file.hpp).
void warn_about_unchecked_files(const std::filesystem::path& in, const Context& context);

/// Reads the depth layer: z in display mm, one channel, with the picture's size. It is in the EXR picture itself, or in
/// aov_0000.exr beside frame_0000..., aov_000.exr beside view_000... None if it does not exist. Throws Error like
/// read_channels().
std::optional<Image> rendered_depth(const std::filesystem::path& picture);

/// Reads the motion layer in the same way: the motion of each point since the previous frame in pixels of its view; two
/// channels, right and down.
std::optional<Image> rendered_motion(const std::filesystem::path& picture);

/// Reads the provenance layer in the same way: the origin of each pixel, as values of Provenance (lippmann/trace/aovs.hpp).
std::optional<Image> rendered_provenance(const std::filesystem::path& picture);

}  // namespace lippmann
