#include "job/screen_for_stereo.hpp"

#include <fmt/core.h>

#include <cmath>

#include "job/panel_size.hpp"
#include "lippmann/core/error.hpp"
#include "optics/eye_height.hpp"

namespace lippmann {
namespace {

constexpr Vec2i kDefaultViewPx{960, 540};  ///< size of a view before it is squeezed

void refuse_in_stereo(bool given, std::string_view parameter) {
  if (given)
    throw usage_error(std::string(parameter), "has no effect on a stereo picture",
                      fmt::format("no `{}`, or another `layout`", parameter));
}

void refuse_other_optics(const OpticsParams& optics) {
  refuse_in_stereo(optics.kind.has_value(), "optics");
  for (const KindParam& param : kKindParams) refuse_in_stereo(param.is_given(optics), param.name);
  refuse_in_stereo(optics.view_angle_deg.has_value(), "view-angle");
}

StereoPacking packing_of(const RenderParams& params) { return params.output.pictures.stereo.packing; }

Vec2i stored_view(const RenderParams& params, const Display* display) {
  const StereoPacking packing = packing_of(params);
  const Extent<int> size = params.optics.size;
  if (size.x > 0) return stored_view_size(packing, {size.x, size.y}, "size");
  const Vec2i whole = display ? display->pixels : kDefaultViewPx;
  return stored_view_size(packing, stereo_picture_size(packing, whole / stereo_squeeze(packing)), "display");
}

Vec2d screen_mm(const RenderParams& params, const Display* display, Vec2i stored) {
  if (display && params.optics.screen_width_mm)
    throw usage_error("screen-width",
                      fmt::format("has no effect: the display {} states the width of its screen", display->name),
                      "either `display` or `screen-width`");
  if (display) return display->size_mm();
  const Vec2d whole(stored * stereo_squeeze(packing_of(params)));
  const double width = params.optics.screen_width_mm.value_or(kDefaultScreenMm);
  return {width, width * whole.y / whole.x};
}

double eyes_distance_mm(const RenderParams& params, const FittedArray& array, const Display* display, double height_mm) {
  const double distance = params.optics.viewing_distance_mm.value_or(
      display ? static_cast<float>(viewing_distance_mm(*display))
              : array.viewing_distance / scene_units_per_mm(array, static_cast<float>(height_mm)));
  // An orthographic camera has no viewing distance.
  if (!params.optics.viewing_distance_mm && !std::isfinite(distance)) return 3.0 * height_mm;
  if (!std::isfinite(distance))
    throw usage_error("viewing-distance", "cannot be infinite for two eyes", "millimetres above 0, or auto");
  return distance;
}

void require_stereo_size(Vec2i film) {
  if (std::int64_t{film.x} * film.y > kMaxPixels || std::max(film.x, film.y) > kMaxSide)
    throw usage_error("size", fmt::format("two views of {}x{} pixels are too large", film.x / 2, film.y),
                      fmt::format("up to {} pixels, at most {} a side", kMaxPixels, kMaxSide));
}

}  // namespace

void refuse_stereo_params(const OpticsParams& optics) {
  if (optics.ipd_mm) throw usage_error("ipd", "has no effect without two eyes", "`layout` stereo");
  if (optics.screen_width_mm) throw usage_error("screen-width", "has no effect without two eyes", "`layout` stereo");
}

Screen screen_for_stereo(const RenderParams& params, const Display* display) {
  refuse_other_optics(params.optics);
  const Vec2i stored = stored_view(params, display);
  require_stereo_size({2 * stored.x, stored.y});
  const Vec2d screen = screen_mm(params, display, stored);
  const auto optics_for = [params, display, stored, screen](const FittedArray& array) -> Optics {
    const Vec2d pixel = screen / Vec2d(stored);
    MultiView eyes{2, 1};
    eyes.distance_mm = static_cast<float>(eyes_distance_mm(params, array, display, screen.y));
    eyes.baseline_mm = static_cast<float>(params.optics.ipd_mm.value_or(kDefaultIpdMm));
    eyes.pixel_height = static_cast<float>(pixel.y / pixel.x);
    return with_eye_height({{2 * stored.x, stored.y, static_cast<float>(pixel.x)}, eyes}, params.optics.eye_height);
  };
  return {static_cast<float>(screen.x / screen.y), optics_for};
}

}  // namespace lippmann
