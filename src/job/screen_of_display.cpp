#include "job/screen_of_display.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "job/panel_size.hpp"
#include "lippmann/core/error.hpp"
#include "optics/eye_height.hpp"
#include "optics/view_spacing.hpp"

namespace lippmann {
namespace {

void refuse(bool given, const char* flag, const char* problem, const char* accepted) {
  if (given) throw usage_error(flag, problem, accepted);
}

void refuse_params_of_display(const RenderParams& params) {
  for (const KindParam& param : kKindParams)
    if (param.name != "views" && param.name != "camera-grid" && param.name != "cone-ends" && param.is_given(params.optics))
      throw usage_error(
          std::string(param.name), "is decided by the display",
          fmt::format("no `{}`, or a display of your own in a .toml file (docs/reference/displays.md)", param.name));
  refuse(params.optics.camera_grid, "--camera-grid", "cannot be combined with --display, whose views are at equal angles",
         "one of the two");
}

/// Applies the requested viewing angle, viewing distance and size. The size of a quilt is not changed here.
Display with_params(const RenderParams& params, Display display, bool is_quilt) {
  if (params.optics.view_angle_deg) display.view_cone_deg = *params.optics.view_angle_deg;
  if (params.optics.viewing_distance_mm) display.viewing_distance_mm = *params.optics.viewing_distance_mm;
  if (params.optics.size.x > 0 && !is_quilt) {
    refuse(display.kind == DisplayKind::kSlantedPanel && optics_kind(params) != OpticsKind::kSingle, "--size",
           "a native frame has the size of its panel", "--layout quilt");
    display.pixels = {params.optics.size.x, params.optics.size.y};
  }
  return display;
}

/// Takes values that `params` lacks from the display's quilt.
Optics wanted_quilt(const RenderParams& params, Display display) {
  refuse(!display.quilt && params.optics.views.x == 0, "--optics multiview", "the display has no quilt",
         "--views CxR and --size WxH");
  DisplayQuilt quilt = display.quilt.value_or(DisplayQuilt{});
  if (params.optics.views.x > 0) quilt.columns = params.optics.views.x, quilt.rows = params.optics.views.y;
  if (params.optics.size.x > 0) quilt.width = params.optics.size.x, quilt.height = params.optics.size.y;
  if (quilt.width < quilt.columns || quilt.height < quilt.rows)
    throw usage_error(
        "--views", fmt::format("{}x{} views do not fit on {}x{} pixels", quilt.columns, quilt.rows, quilt.width, quilt.height),
        "fewer views");
  display.quilt = quilt;
  return with_cone_ends(*quilt_optics(display), params.optics.cone_ends);
}

Optics single_optics(const Display& display) {
  Optics optics;
  optics.panel = {display.pixels.x, display.pixels.y, static_cast<float>(display.pixel_mm())};
  optics.model = SingleView{static_cast<float>(viewing_distance_mm(display)), {}};
  return optics;
}

OpticsKind own_kind(const Display& display) {
  if (display.kind == DisplayKind::kLenticularSheet) return OpticsKind::kLenticular;
  return display.kind == DisplayKind::kMicrolensArray ? OpticsKind::kMicrolens : OpticsKind::kMultiview;
}

void require_size(Vec2i film) {
  const std::int64_t pixels = std::int64_t{film.x} * film.y;
  if (pixels > kMaxPixels || std::max(film.x, film.y) > kMaxSide)
    throw usage_error("--display", fmt::format("a frame would have {}x{} pixels", film.x, film.y),
                      fmt::format("1 to {} pixels, at most {} a side; --size sets a smaller one", kMaxPixels, kMaxSide));
}

Optics display_optics(const RenderParams& params, const Display& display) {
  refuse_params_of_display(params);
  const bool slanted = display.kind == DisplayKind::kSlantedPanel,
             native = params.output.pictures.layout == PictureLayout::kNative;
  const OpticsKind kind = params.optics.kind.value_or(own_kind(display));
  const bool is_quilt = kind == OpticsKind::kMultiview && !(slanted && native);
  refuse(params.optics.views.x > 0 && !is_quilt, "--views", "has no effect on this kind of optics", "--optics multiview");
  refuse(params.optics.cone_ends && !is_quilt, "--cone-ends", "has no effect on this kind of optics", "--optics multiview");
  const Display wanted = with_params(params, display, is_quilt);
  Optics optics;
  if (kind == OpticsKind::kSingle)
    optics = single_optics(wanted);
  else if (is_quilt)
    optics = wanted_quilt(params, wanted);
  else if (kind == own_kind(display))
    optics = native_optics(wanted);
  else
    throw usage_error("--optics", fmt::format("{} is a {}, which decides the optics", display.name, to_string(display.kind)),
                      "no --optics, or --optics multiview or single");
  require_size(film_size(optics));
  return with_eye_height(std::move(optics), params.optics.eye_height);
}

}  // namespace

Screen screen_of_display(const RenderParams& params, const Display& display) {
  const Optics optics = display_optics(params, display);
  const Vec2f window = window_size_mm(optics);
  return {window.x / window.y, [optics](const FittedArray&) { return optics; }};
}

}  // namespace lippmann
