// Light fields made into stereo pictures: what two eyes before the display see of it (replay/eye_view.hpp).
//
// The eyes stand level with the design viewer, half the distance of the pupils to either side. Both look through the same
// rectangle of the plane z = 0, so that their pictures are off-axis and lie on one another there.
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
  std::filesystem::path in;   ///< as of find_light_field_frames
  std::filesystem::path out;  ///< a picture, or for several frames a folder
  LightFieldHints field = {};
  StereoLayout layout = {};
  std::optional<double> ipd_mm = {};           ///< between the pupils; none: kUsualIpdMm
  std::optional<double> distance_mm = {};      ///< from the eyes to the screen; none: the design viewer's
  std::optional<double> screen_width_mm = {};  ///< on which the light field is shown; none: as wide as its optics say
};

struct ConvertedStereo {
  std::vector<std::filesystem::path> written;
  Vec2i view_size{0, 0};     ///< a whole view's
  double out_of_zone = 0.0;  ///< the larger share of the display through which an eye sees another zone (eye_sampler.hpp)
};

/// The views of a light field of two views are taken as they are; then lengths and an angle are errors. Warns of eyes out of
/// the viewing zone. Throws Error naming the file or parameter. When context.cancelled is set, it stops at once: pictures that
/// are finished stay, the one under way leaves nothing.
ConvertedStereo convert_to_stereo(const StereoParams& params, const Context& context);

/// What two eyes see of one panel, as a light field of 2 views; they are `ipd_mm` apart around `eye_mm`. Unfinished when
/// `context` is cancelled.
LightField stereo_views(const RenderedPanel& panel, Vec3d eye_mm, double ipd_mm, const ThreadPool& pool,
                        const Context& context = {});

}  // namespace lippmann
