#include "lippmann/replay/epipolar_image.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/eye_view.hpp"

namespace lippmann {
namespace {

void check_line(const char* flag, int line, int count, const char* what) {
  if (line < 0 || line >= count)
    throw usage_error(flag, fmt::format("there is no {} {}", what, line), fmt::format("0 to {}", count - 1));
}

void set(Image& picture, int x, int y, Vec3f color) { std::copy_n(&color.x, 3, picture.pixel(x, y)); }

}  // namespace

Image epipolar_row(const RenderedPanel& rendered, int row, SampleFilter filter, const Context& context) {
  const Vec2i grid = lens_grid(rendered.optics);
  check_line("epi", row, grid.y, "row");
  const int eyes = view_counts(rendered.optics).x;
  const Window window = display_window(rendered.optics);
  const EyeSampler sampler(rendered, filter);
  Image picture(grid.x, eyes, 3);
  for (int eye = 0; eye < eyes && !context.cancelled; ++eye) {
    const Viewer viewer = viewer_in_zone(rendered.optics, (eye + 0.5) / eyes);
    for (int x = 0; x < grid.x; ++x) set(picture, x, eye, sampler.color(viewer, window.point_at({x + 0.5, row + 0.5}, grid)));
  }
  return picture;
}

Image epipolar_column(const RenderedPanel& rendered, int column, SampleFilter filter, const Context& context) {
  if (!parallax_of(rendered.optics).along)
    throw usage_error("epi-column", "these optics have no vertical parallax", "`epi`, or pictures of a microlens array");
  const Vec2i grid = lens_grid(rendered.optics);
  check_line("epi-column", column, grid.x, "column");
  const int eyes = view_counts(rendered.optics).y;
  const Window window = display_window(rendered.optics);
  const EyeSampler sampler(rendered, filter);
  Image picture(eyes, grid.y, 3);
  for (int eye = 0; eye < eyes && !context.cancelled; ++eye) {
    const Viewer viewer = viewer_in_zone_vertically(rendered.optics, (eye + 0.5) / eyes);
    for (int y = 0; y < grid.y; ++y)
      set(picture, eye, y, sampler.color(viewer, window.point_at({column + 0.5, y + 0.5}, grid)));
  }
  return picture;
}

}  // namespace lippmann
