// Reads the files that `render` wrote beside a picture: report.json, which has the picture's optics, and layers.
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

struct FrameFacts {
  std::string kind = {};  ///< "full", "key" or "in-between"; empty: the report does not state it
  /// PSNR that was estimated during rendering; none: the frame is exact or has no estimate.
  std::optional<double> psnr_db = {};
};

struct Rendering {
  Optics optics;
  /// Value of the setting `layout` or `to`: integral, views, quilt, ...; empty: native layout of the optics.
  std::string layout = {};
  bool mirrored = false;        ///< left and right are swapped, for prints on the back of a sheet
  bool has_depth_layer = true;  ///< false: ignore depth layers in the folder, which are from another render
  bool has_provenance = false;  ///< false: ignore provenance layers in the folder, which are from another render
  std::optional<double> frames_per_second = {};
  float depth_scale = 1.0f;  ///< shown depth / true depth
  std::map<int, FrameFacts> frames = {};
};

/// Returns the frame rate that a report states; none if the rate is missing or implausible.
std::optional<double> frame_rate_of(const nlohmann::ordered_json& report);

/// Throws Error naming the report if it is malformed or has no optics.
Rendering read_rendering(const std::filesystem::path& report);

/// Reads the report.json in the folder of the picture (or folder of views), or in its parent; none if there is no
/// report. Throws Error naming the report if it is malformed.
std::optional<Rendering> rendering_of(const std::filesystem::path& picture);

/// Reads a report that is not needed to show the pictures. Returns none if the report is missing or malformed.
std::optional<Rendering> readable_rendering(const std::filesystem::path& report);

/// Warns about files of a render that no journal lists, because they cannot be checked for damage (core/recorded_file.hpp).
void warn_about_unchecked_files(const std::filesystem::path& in, const Context& context);

/// Reads the depth layer of a picture: z in display mm, one channel, with the picture's size. It is in the EXR picture
/// itself, or in aov_0000.exr beside frame_0000..., or aov_000.exr beside view_000... Returns none if the layer does
/// not exist. Throws Error as read_channels() does.
std::optional<Image> rendered_depth(const std::filesystem::path& picture);

/// Reads the motion layer, stored like the depth layer: the motion of each point since the previous frame, in pixels of
/// its view; two channels, right and down.
std::optional<Image> rendered_motion(const std::filesystem::path& picture);

/// Reads the provenance layer, stored like the depth layer: how each pixel was made, as values of Provenance
/// (lippmann/trace/aovs.hpp).
std::optional<Image> rendered_provenance(const std::filesystem::path& picture);

}  // namespace lippmann
