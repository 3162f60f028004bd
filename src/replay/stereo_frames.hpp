// Converts light fields to stereo images: what two eyes in front of the display see (replay/eye_view.hpp).
//
// The eyes are level with the design viewer. Both look through the same rectangle of the plane z = 0, so the views are
// off-axis.
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
  std::filesystem::path in;
  std::filesystem::path out;
  LightFieldHints field = {};
  StereoLayout layout = {};
  std::optional<double> ipd_mm = {};           ///< distance between the eyes; none: kDefaultIpdMm
  std::optional<double> distance_mm = {};      ///< distance from the eyes to the screen; none: as for the design viewer
  std::optional<double> screen_width_mm = {};  ///< width of the viewer's screen; none: as in the optics
};

struct ConvertedStereo {
  std::vector<std::filesystem::path> written;
  Vec2i view_size{0, 0};     ///< size of one view before it is squeezed
  double out_of_zone = 0.0;  ///< largest fraction of the display on which an eye sees a neighbouring viewing zone
};

/// If the light field has two views, copies them, and throws Error if `params` gives lengths. Warns if an eye is outside the
/// viewing zone. Throws Error naming the file or parameter. Stops at once if context.cancelled is set; finished images remain.
ConvertedStereo convert_to_stereo(const StereoParams& params, const Context& context);

/// Returns the views of two eyes that are ipd_mm apart, with their middle at eye_mm. The light field is unfinished if `context`
/// is cancelled.
LightField stereo_views(const RenderedPanel& panel, Vec3d eye_mm, double ipd_mm, const ThreadPool& pool,
                        const Context& context = {});

}  // namespace lippmann
