#include "lippmann/layout/display_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "layout/lens_interlace.hpp"
#include "layout/oriented.hpp"
#include "layout/picture_samples.hpp"
#include "layout/print_finish.hpp"
#include "layout/strip_interlace.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"

namespace lippmann {
namespace {

/// Spreads eyes evenly over the viewing zone of a microlens array, across and up.
ViewCameras eyes_over_zone(const LightField& field, const Display& array) {
  const Optics optics = native_optics(array);
  const double distance = viewing_distance_mm(array), zone = 2.0 * distance * std::tan(0.5 * viewing_zone(optics));
  const Vec2d step(zone / field.grid.columns, zone / field.grid.rows);
  ViewCameras cameras{distance, display_window(optics).size / Vec2d(field.view_size), 0.5 * Vec2d(field.view_size), {}};
  for (int row = 0; row < field.grid.rows; ++row)
    for (int column = 0; column < field.grid.columns; ++column)
      cameras.eyes_mm.push_back((Vec2d(column, row) - 0.5 * Vec2d(field.grid.columns - 1, field.grid.rows - 1)) * step);
  return cameras;
}

Picture array_picture(const LightField& field, const Display& array, const DisplayPictureParams& params,
                      const ThreadPool& pool) {
  if (params.filter != ViewFilter::kNearest)
    throw usage_error("filter", "microlens arrays support only the nearest view", "nearest");
  LightField with_eyes = field;
  with_eyes.cameras = eyes_over_zone(field, array);
  return interlace_behind_lenses(with_eyes, array, pool);
}

/// Returns the picture for one tile of a quilt: the nearest view, or a blend of the two nearest views in linear light.
Picture view_of_tile(const LightField& field, int tile, int tiles, ViewFilter filter) {
  const int count = field.grid.count();
  const double place = (tile + 0.5) * count / tiles;
  if (filter == ViewFilter::kNearest || tiles == count) return view_of(field, static_cast<int>(place));
  const double within = std::clamp(place - 0.5, 0.0, count - 1.0);
  const int first = static_cast<int>(within);
  const auto share = static_cast<float>(within - first);
  const Picture near = view_of(field, first);
  if (share == 0.0f) return near;
  Image mixed = to_linear(near);
  const Image next = to_linear(view_of(field, first + 1));
  for (std::size_t i = 0; i < mixed.data.size(); ++i) mixed.data[i] = std::lerp(mixed.data[i], next.data[i], share);
  return with_samples_like(near, std::move(mixed));
}

void put_tile(const Picture& view, const ViewPlace& place, Picture& quilt) {
  const Vec2i size = size_of(view);
  std::visit(
      [&](const auto& from) {
        auto& to = samples_of(std::get<std::remove_cvref_t<decltype(from)>>(quilt));
        for (int y = 0; y < size.y; ++y)
          std::copy_n(samples_of(from).begin() + static_cast<std::ptrdiff_t>(3) * y * size.x, 3 * size.x,
                      to.begin() + 3 * (place.first + y * place.down));
      },
      view);
}

Picture quilt_picture(const LightField& field, const Display& display, ViewFilter filter) {
  if (filter == ViewFilter::kGaussian)
    throw usage_error("filter", "gaussian works for slanted panels only", "nearest or linear");
  const DisplayQuilt& quilt = *display.quilt;
  const int tiles = quilt.columns * quilt.rows;
  const ViewLayout layout{LayoutKind::kQuilt, {tiles, 1}, {quilt.columns, quilt.rows}};
  const Vec2i size(quilt.width, quilt.height);
  Picture picture = blank(field.stack, size);
  for (int tile = 0; tile < tiles; ++tile)
    put_tile(view_of_tile(field, tile, tiles, filter), place_of_view(layout, field.view_size, size, tile), picture);
  return picture;
}

void require_views(const LightField& field, const Display& display) {
  if (field.grid.count() < 2)
    throw usage_error("views", "a single picture looks the same from all directions", "2 or more pictures after `keep`");
  if (field.grid.rows > 1 && display.kind != DisplayKind::kMicrolensArray)
    throw usage_error(
        "views",
        fmt::format("{} shows one row of views, but there are {}x{}", display.name, field.grid.columns, field.grid.rows),
        "one row of views; `keep` can select one");
}

}  // namespace

DisplayTarget display_target(const Display& display, std::string_view format) {
  const bool is_panel = display.kind == DisplayKind::kSlantedPanel;
  if (format == "integral" && is_panel)
    throw usage_error("display", display.name + " is a slanted panel, whose picture is its native frame",
                      "`to` native" + std::string(display.quilt ? " or quilt" : ""));
  if (format == "native") require_own_frame(display);
  if (format == "quilt" && !display.quilt)
    throw usage_error("display", display.name + " has no quilt", "`to` " + std::string(own_format(display)));
  if (format == "quilt") return DisplayTarget::kQuilt;
  return format == "native" ? DisplayTarget::kNative : DisplayTarget::kIntegral;
}

std::string_view own_format(const Display& display) {
  return display.kind == DisplayKind::kSlantedPanel ? "native" : "integral";
}

Picture display_picture(const LightField& field, const Display& display, DisplayTarget target,
                        const DisplayPictureParams& params, const ThreadPool& pool) {
  require_views(field, display);
  if (target != DisplayTarget::kIntegral && !params.finish.is_plain())
    throw usage_error("marks", "bleed, marks and proofs need a print", "the display of a sheet or an array of lenses");
  const auto picture = [&] {
    if (target == DisplayTarget::kQuilt) return quilt_picture(field, display, params.filter);
    if (target == DisplayTarget::kNative) return interlace(field, display, {params.filter, params.sigma_views}, pool);
    if (display.kind == DisplayKind::kMicrolensArray) return array_picture(field, display, params, pool);
    return interlace_strips(field, display, params, pool);
  };
  return oriented(finished(picture(), display, params.finish), params.mirror, params.turn_deg);
}

}  // namespace lippmann
