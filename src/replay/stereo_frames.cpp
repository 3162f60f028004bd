#include "replay/stereo_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/folder.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/formats/quilt_name.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/eye_view.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct EyePair {
  Vec3d middle_mm;
  double ipd_mm;

  Vec3d eye(int i) const { return middle_mm + Vec3d((i - 0.5) * ipd_mm, 0.0, 0.0); }
};

/// The lengths in `params` refer to the viewer's screen. They are scaled if the optics have another width.
EyePair eye_pair(const StereoParams& params, const Optics& optics) {
  const double width = display_window(optics).size.x, scale = params.screen_width_mm ? width / *params.screen_width_mm : 1.0;
  EyePair eyes{default_eye_mm(optics), params.ipd_mm.value_or(kDefaultIpdMm) * scale};
  if (params.distance_mm) eyes.middle_mm.z = *params.distance_mm * scale;
  return eyes;
}

bool is_pair(const Optics& optics) {
  const std::optional<ViewTiles> tiles = view_tiles(optics);
  return tiles && tiles->columns == 2 && tiles->rows == 1;
}

/// Throws if parameters of the eyes are given. They have no effect on light fields of two views.
void refuse_eye_params(const StereoParams& params) {
  const auto refuse = [](bool given, const char* flag) {
    if (given)
      throw usage_error(flag, "has no effect on a light field of two views, which are shown unchanged",
                        "a light field of 3 or more views");
  };
  refuse(params.ipd_mm.has_value(), "ipd");
  refuse(params.distance_mm.has_value(), "viewing-distance");
  refuse(params.screen_width_mm.has_value(), "screen-width");
  refuse(params.field.view_angle_deg.has_value(), "view-angle");
  refuse(params.field.cone_ends, "cone-ends");
}

/// Warns if an eye is outside the viewing zone. Returns the largest fraction of the display on which an eye sees a neighbouring
/// viewing zone.
double warn_out_of_zone(const Optics& optics, const EyePair& eyes, const Context& context) {
  const double share =
      std::max(share_out_of_zone(optics, viewer_at(eyes.eye(0))), share_out_of_zone(optics, viewer_at(eyes.eye(1))));
  if (!(share > 0.0)) return share;
  const double width = display_window(optics).size.x;
  const double zone = zone_x_mm(optics, 1.0, eyes.middle_mm.z) - zone_x_mm(optics, 0.0, eyes.middle_mm.z);
  context.warning(fmt::format(
      "Eyes {:.4g} mm apart and {:.4g} mm from a display {:.4g} mm wide are outside the viewing zone of {:.3g} % of it. "
      "The zone is {:.4g} mm wide there: use a smaller `ipd`, or set `screen-width` to the real width of the screen.",
      eyes.ipd_mm, eyes.middle_mm.z, width, 100.0 * share, zone));
  return share;
}

LightField with_codes(LightField field, bool wants_floats) {
  if (!wants_floats)
    if (const Image* light = std::get_if<Image>(&field.stack)) field.stack = to_codes(*light, Encoding::kSrgb);
  return field;
}

bool wants_floats(const fs::path& out, const fs::path& in) {
  return (out.has_extension() ? out.extension() : in.extension()) == ".exr";
}

fs::path with_ending_of(const fs::path& out, const fs::path& in) {
  return fs::path(out) += in.extension() == ".exr" ? ".exr" : ".png";
}

}  // namespace

LightField stereo_views(const RenderedPanel& panel, Vec3d eye_mm, double ipd_mm, const ThreadPool& pool,
                        const Context& context) {
  LightField field;
  const EyePair eyes{eye_mm, ipd_mm};
  for (int i = 0; i < 2; ++i) {
    EyeView view;
    view.eye_mm = eyes.eye(i);
    validate(view);
    const Image seen = eye_view(panel, view, pool, context);
    if (i == 0) {
      field.grid = {2, 1}, field.view_size = {seen.width, seen.height};
      field.stack = Image(seen.width, 2 * seen.height, 3);
    }
    set_view(field, i, seen);
  }
  const Vec2d window = display_window(panel.optics).size;
  field.aspect = window.x / window.y;
  return field;
}

ConvertedStereo convert_to_stereo(const StereoParams& params, const Context& context) {
  const LightFieldFrames frames = find_light_field_frames(params.in, with_warnings(params.field, context));
  const EyePair eyes = eye_pair(params, frames.optics);
  const ThreadPool pool(resolved_threads(context));
  const bool pair = is_pair(frames.optics), one = frames.files.size() == 1 && frames.files.front() == params.in;
  if (pair) refuse_eye_params(params);
  ConvertedStereo made;
  if (!pair && !frames.assumption.empty()) context.warning(frames.assumption);
  if (!pair) made.out_of_zone = warn_out_of_zone(frames.optics, eyes, context);
  FormatOptions reading, writing;
  reading.views = params.field.views, reading.tiles = params.field.tiles, writing.stereo = params.layout;
  reading.warn = context.warn;
  const NewFolder folder(one ? params.out.parent_path() : params.out);
  for (std::size_t i = 0; i < frames.files.size() && !context.cancelled; ++i) {
    const fs::path& in = frames.files[i];
    const fs::path name = without_stereo_name(without_quilt_name(in.filename())).stem();
    const fs::path out =
        one && params.out.has_extension() ? params.out : with_ending_of(one ? params.out : params.out / name, in);
    const LightField field =
        pair ? open_light_field(in, params.field.from, reading).field
             : with_codes(stereo_views(frames.read(i), eyes.middle_mm, eyes.ipd_mm, pool, context), wants_floats(out, in));
    if (context.cancelled) break;
    for (fs::path& file : stereo_format().write(field, out, writing)) made.written.push_back(std::move(file));
    made.view_size = field.view_size;
  }
  return made;
}

}  // namespace lippmann
