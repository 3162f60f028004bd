#include "layout/lens_interlace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "layout/picture_samples.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"

namespace lippmann {
namespace {

/// Evenly spaced eyes along one axis, from the lowest coordinate.
struct EyeAxis {
  double first = 0.0, step = 0.0;
  int count = 1;

  int nearest(double place) const {
    if (count == 1) return 0;
    return static_cast<int>(std::clamp(std::floor((place - first) / step + 0.5), 0.0, count - 1.0));
  }
};

struct EyeGrid {
  EyeAxis across, up;

  explicit EyeGrid(const LightField& field) {
    const std::vector<Vec2d>& eyes = field.cameras->eyes_mm;
    const int columns = field.grid.columns, rows = field.grid.rows;
    const Vec2d first = eyes.front(), last = eyes.back();
    across = {first.x, (last.x - first.x) / std::max(1, columns - 1), columns};
    up = {first.y, (last.y - first.y) / std::max(1, rows - 1), rows};
  }
  int nearest(Vec2d place) const { return up.nearest(place.y) * across.count + across.nearest(place.x); }
};

/// Two neighbouring samples along one axis. `share` is the weight of `next`.
struct SamplePair {
  int at, next;
  double share;

  SamplePair(double place, int count) {
    const double within = std::clamp(place - 0.5, 0.0, count - 1.0);
    at = static_cast<int>(within), next = std::min(at + 1, count - 1), share = within - at;
  }
};

template <class Sample>
class LensInterlacer {
 public:
  LensInterlacer(const LightField& field, const Optics& optics, const std::vector<Sample>& views)
      : field_(field), optics_(optics), eyes_(field), window_(display_window(optics)), views_(views) {}

  void write_row(int j, Sample* out) const {
    for (int i = 0; i < optics_.panel.width; ++i, out += 3) write_pixel(ray_of_pixel(optics_, Vec2f(i, j) + 0.5f), out);
  }

 private:
  void write_pixel(const Ray& ray, Sample* out) const {
    const Vec2d slope = Vec2d(ray.direction) / static_cast<double>(ray.direction.z);
    const Vec2d through = Vec2d(ray.origin) - slope * static_cast<double>(ray.origin.z);
    const int view = eyes_.nearest(through + slope * field_.cameras->distance_mm);
    const Vec2d at = window_.pixel_at(through, field_.view_size);
    const SamplePair x(at.x, field_.view_size.x), y(at.y, field_.view_size.y);
    for (int c = 0; c < 3; ++c) {
      const auto in_row = [&](int row) { return std::lerp(sample(view, x.at, row, c), sample(view, x.next, row, c), x.share); };
      out[c] = nearest_sample<Sample>(std::lerp(in_row(y.at), in_row(y.next), y.share));
    }
  }

  double sample(int view, int x, int y, int c) const {
    const std::size_t row =
        static_cast<std::size_t>(view) * static_cast<std::size_t>(field_.view_size.y) + static_cast<std::size_t>(y);
    return static_cast<double>(views_[3 * (row * static_cast<std::size_t>(field_.view_size.x) + static_cast<std::size_t>(x)) +
                                      static_cast<std::size_t>(c)]);
  }

  const LightField& field_;
  const Optics& optics_;
  const EyeGrid eyes_;
  const Window window_;
  const std::vector<Sample>& views_;
};

ViewGrid views_below_lens(const Optics& lenses) {
  const Vec2i counts = view_counts(lenses);
  return {counts.x, counts.y};
}

void require_fewer_views(ViewGrid grid, const Display& display) {
  if (grid.columns <= display.pixels.x && grid.rows <= display.pixels.y) return;
  throw usage_error(
      "views",
      fmt::format("{}x{} views do not fit on {}x{} pixels", grid.columns, grid.rows, display.pixels.x, display.pixels.y),
      "fewer views");
}

}  // namespace

Optics lens_views(const Display& display, const std::optional<ViewGrid>& views) {
  const Optics lenses = native_optics(display);
  const ViewGrid grid = views.value_or(views_below_lens(lenses));
  require_fewer_views(grid, display);
  const Vec2i view = lens_grid(lenses);
  const Vec2d pixel = display_window(lenses).size / Vec2d(view);
  MultiView eyes{grid.columns, grid.rows};
  eyes.distance_mm = viewing_distance_mm(lenses);
  eyes.baseline_mm =
      2.0f * eyes.distance_mm * std::tan(0.5f * viewing_zone(lenses)) / static_cast<float>(std::max(grid.columns, grid.rows));
  eyes.pixel_height = static_cast<float>(pixel.y / pixel.x);
  return {{view.x * grid.columns, view.y * grid.rows, static_cast<float>(pixel.x)}, eyes};
}

Picture interlace_behind_lenses(const LightField& field, const Display& display, const ThreadPool& pool) {
  const Optics lenses = native_optics(display);
  Picture picture = blank(field.stack, display.pixels);
  std::visit(
      [&](auto& to) {
        const auto& from = std::get<std::remove_cvref_t<decltype(to)>>(field.stack);
        using Sample = typename std::remove_cvref_t<decltype(samples_of(to))>::value_type;
        const LensInterlacer<Sample> interlacer(field, lenses, samples_of(from));
        const std::size_t row = 3 * static_cast<std::size_t>(display.pixels.x);
        pool.for_each(static_cast<std::size_t>(display.pixels.y),
                      [&](std::size_t j) { interlacer.write_row(static_cast<int>(j), samples_of(to).data() + j * row); });
      },
      picture);
  return picture;
}

}  // namespace lippmann
