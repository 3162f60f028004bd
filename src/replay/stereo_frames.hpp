// Converts light fields to stereo images: what two eyes in front of the display see (replay/eye_view.hpp).
//
// The eyes are level with the design viewer, at half the interpupillary distance to either side. Both look through the same
// rectangle of the plane z = 0. The views are therefore off-axis, and points in that plane coincide.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/layout/stereo.hpp"
#include "lippmann/replay/light_field_frames.hpp"

namespace lippmann {

struct StereoParams {
  std::filesystem::path in;   ///< the input, as for find_light_field_frames
  std::filesystem::path out;  ///< the output: an image, or a folder if there are several frames
  LightFieldHints field = {};
  StereoLayout layout = {};
  std::optional<double> ipd_mm = {};           ///< interpupillary distance; none: kDefaultIpdMm
  std::optional<double> distance_mm = {};      ///< distance from the eyes to the screen; none: that of the design viewer
  std::optional<double> screen_width_mm = {};  ///< width of the screen that shows the light field; none: as in its optics
};

struct ConvertedStereo {
  std::vector<std::filesystem::path> written;
  Vec2i view_size{0, 0};     ///< size of one view before it is squeezed
  double out_of_zone = 0.0;  ///< largest result of share_out_of_zone() (eye_sampler.hpp), over all eyes and frames
};

/// Converts all frames. A light field of two views keeps its views; giving the distances or the view angle is then an Error.
/// Warns if an eye is outside the viewing zone. Throws Error naming the file or parameter. Stops at once if context.cancelled
/// is set; finished images remain, and the unfinished one leaves no file.
ConvertedStereo convert_to_stereo(const StereoParams& params, const Context& context);

/// Returns what two eyes see of one panel, as a light field of 2 views. The eyes are ipd_mm apart, with eye_mm in the middle.
/// The result is unfinished if `context` is cancelled.
LightField stereo_views(const RenderedPanel& panel, Vec3d eye_mm, double ipd_mm, const ThreadPool& pool,
                        const Context& context = {});

}  // namespace lippmann
