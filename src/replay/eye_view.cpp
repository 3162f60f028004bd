#include "replay/eye_view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "replay/sight.hpp"
#include "replay/viewing.hpp"

namespace lippmann {
namespace {

constexpr double kPanelEdgePx = 1e-3;  ///< so far outside, a point is still of the panel: rounding

struct Quality {
  SampleFilter filter;
  double crosstalk_px;
};

/// Sums pixels by weight; `wanted(x, y)` says which of them count.
template <class Wanted>
Vec3f weighted_mean(const Image& picture, const Taps& columns, const Taps& rows, const Wanted& wanted) {
  Vec3d sum(0.0);
  double weights = 0.0;
  for (const Tap& row : rows)
    for (const Tap& column : columns) {
      const double weight = row.weight * column.weight;
      if (weight <= 0.0 || !wanted(column.index, row.index)) continue;
      const float* p = picture.pixel(column.index, row.index);
      sum += weight * Vec3d(p[0], p[1], p[2]);
      weights += weight;
    }
  return weights > 0.0 ? Vec3f(sum / weights) : Vec3f(0.0f);
}

/// A sheet or a microlens array.
template <class Sight>
class LensSampler {
 public:
  LensSampler(const Sight& sight, const RenderedPanel& rendered, const Quality& quality)
      : sight_(sight), picture_(rendered.picture), quality_(quality) {}

  Vec3f color(const Viewer& viewer, Vec2d point_mm) const {
    Vec2d q = sight_.seen_from(viewer, point_mm).pixel;
    const Vec2d size(picture_.width, picture_.height);
    for (int axis = 0; axis < 2; ++axis) {
      if (!(q[axis] >= -kPanelEdgePx && q[axis] <= size[axis] + kPanelEdgePx)) return Vec3f(0.0f);
      q[axis] = std::clamp(q[axis], 0.0, std::nextafter(size[axis], 0.0));
    }
    const Taps columns = taps(q.x, sight_.pixel_across().x), rows = taps(q.y, sight_.pixel_across().y);
    const auto on_panel = [&](int x, int y) { return x >= 0 && y >= 0 && x < picture_.width && y < picture_.height; };
    if (quality_.crosstalk_px > 0.0 || quality_.filter == SampleFilter::kNearest)
      return weighted_mean(picture_, columns, rows, on_panel);
    const CellOf cell = sight_.cell(q);
    const Vec3f mean = weighted_mean(picture_, columns, rows, [&](int x, int y) {
      return on_panel(x, y) && sight_.cell({x + 0.5, y + 0.5}) == cell;
    });
    return mean;
  }

  bool in_zone(const Viewer& viewer, Vec2d point_mm) const {
    const PanelPoint seen = sight_.seen_from(viewer, point_mm);
    return sight_.cell(seen.pixel) == seen.lens;
  }

 private:
  Taps taps(double position, double pixel_across) const {
    if (quality_.crosstalk_px > 0.0 && pixel_across > 0.0)
      return gaussian_taps(position, std::min(quality_.crosstalk_px / pixel_across, kMaxBlurPx));
    return taps_at(position, quality_.filter);
  }

  Sight sight_;
  const Image& picture_;
  Quality quality_;
};

/// A quilt, or a single view.
class QuiltSampler {
 public:
  QuiltSampler(const QuiltSight& sight, const RenderedPanel& rendered, const Quality& quality)
      : sight_(sight), picture_(rendered.picture), quality_(quality) {}

  Vec3f color(const Viewer& viewer, Vec2d point_mm) const {
    const QuiltPoint seen = sight_.seen_from(viewer, point_mm);
    const Vec2d tile(sight_.tile_size());
    for (int axis = 0; axis < 2; ++axis)
      if (!(seen.pixel[axis] >= -kPanelEdgePx && seen.pixel[axis] <= tile[axis] + kPanelEdgePx)) return Vec3f(0.0f);
    const Taps columns = taps_at(seen.pixel.x, quality_.filter), rows = taps_at(seen.pixel.y, quality_.filter);
    const double view = seen.view + 0.5;  // views as pixels: view v covers v ... v + 1
    const Taps views =
        quality_.crosstalk_px > 0.0 ? gaussian_taps(view, quality_.crosstalk_px) : taps_at(view, quality_.filter);
    Vec3f sum(0.0f);
    double weights = 0.0;
    for (const Tap& tap : views) {
      if (tap.weight <= 0.0 || tap.index < 0 || tap.index >= sight_.views()) continue;
      sum += static_cast<float>(tap.weight) * in_tile(tap.index, columns, rows);
      weights += tap.weight;
    }
    return weights > 0.0 ? sum / static_cast<float>(weights) : Vec3f(0.0f);
  }

  bool in_zone(const Viewer& viewer, Vec2d point_mm) const { return sight_.seen_from(viewer, point_mm).in_zone; }

 private:
  Vec3f in_tile(int view, Taps columns, Taps rows) const {
    const Vec2i origin = sight_.tile_origin(view), size = sight_.tile_size();
    const auto shift = [](Taps& taps, int by) {
      for (int i = 0; i < taps.count; ++i) taps.tap[static_cast<std::size_t>(i)].index += by;
    };
    shift(columns, origin.x), shift(rows, origin.y);
    return weighted_mean(picture_, columns, rows, [&](int x, int y) {
      return x >= origin.x && y >= origin.y && x < origin.x + size.x && y < origin.y + size.y;
    });
  }

  QuiltSight sight_;
  const Image& picture_;
  Quality quality_;
};

using Sampler = std::variant<LensSampler<LenticularSight>, LensSampler<MicrolensSight>, QuiltSampler>;

Sampler make_sampler(const RenderedPanel& rendered, const Quality& quality) {
  const Panel& panel = rendered.optics.panel;
  if (const auto* sheet = std::get_if<LenticularSheet>(&rendered.optics.model))
    return LensSampler<LenticularSight>({panel, *sheet}, rendered, quality);
  if (const auto* array = std::get_if<MicrolensArray>(&rendered.optics.model))
    return LensSampler<MicrolensSight>({panel, *array}, rendered, quality);
  if (const auto* views = std::get_if<MultiView>(&rendered.optics.model))
    return QuiltSampler({panel, *views}, rendered, quality);
  return QuiltSampler({panel, std::get<SingleView>(rendered.optics.model)}, rendered, quality);
}

/// Points spread evenly over a disc of that diameter: Vogel, "A better way to construct the sunflower head", Math. Biosciences
/// 44, 1979.
std::vector<Vec2d> pupil_points(double diameter_mm, int count) {
  if (diameter_mm == 0.0) return {Vec2d(0.0)};
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<Vec2d> points;
  for (int i = 0; i < count; ++i) {
    const double radius = 0.5 * diameter_mm * std::sqrt((i + 0.5) / count), angle = i * golden_angle;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

/// Samples across and down in each pixel of a view that is coarser than the display.
Vec2i samples_per_pixel(const Optics& optics, Vec2i size) {
  constexpr int kMost = 16;
  const Vec2i grid = lens_grid(optics);
  return glm::clamp((grid + size - 1) / size, Vec2i(1), Vec2i(kMost));
}

}  // namespace

struct EyeSampler::Impl {
  Sampler sampler;
};

EyeSampler::EyeSampler(const RenderedPanel& rendered, SampleFilter filter, double crosstalk_px)
    : impl_(std::make_unique<Impl>(Impl{make_sampler(rendered, {filter, crosstalk_px})})) {}
EyeSampler::~EyeSampler() = default;
EyeSampler::EyeSampler(EyeSampler&&) noexcept = default;

Vec3f EyeSampler::color(const Viewer& viewer, Vec2d point_mm) const {
  return std::visit([&](const auto& sampler) { return sampler.color(viewer, point_mm); }, impl_->sampler);
}

void validate(const EyeView& view) {
  constexpr double kFarthestMm = 1e9;
  const Vec3d eye = view.eye_mm;
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(eye[axis]) <= kFarthestMm))
      throw usage_error("--eye", fmt::format("({}, {}, {}) mm is no place", eye.x, eye.y, eye.z),
                        "X,Y,Z in mm of the display frame");
  if (!(eye.z > 0.0))
    throw usage_error("--eye", fmt::format("an eye at z = {} mm is not in front of the display plane z = 0", eye.z), "z > 0");
  if (!(view.pupil_mm >= 0.0 && view.pupil_mm <= kFarthestMm) || view.pupil_points < 1)
    throw usage_error("--pupil", fmt::format("{} mm is no diameter", view.pupil_mm), "0 (a pinhole) or more");
  if (!(view.crosstalk_px >= 0.0 && view.crosstalk_px <= kMaxBlurPx))
    throw usage_error("--crosstalk", fmt::format("{} pixels", view.crosstalk_px), fmt::format("0 to {}", kMaxBlurPx));
}

Image eye_view(const RenderedPanel& rendered, const EyeView& view, const ThreadPool& pool) {
  const Window window = display_window(rendered.optics);
  const Vec2i size = view.size.x > 0 ? view.size : natural_view_size(rendered.optics);
  const Vec2i samples = samples_per_pixel(rendered.optics, size);
  const EyeSampler sampler(rendered, view.filter, view.crosstalk_px);
  std::vector<Viewer> viewers;
  for (const Vec2d& point : pupil_points(view.pupil_mm, view.pupil_points))
    viewers.push_back(viewer_at(view.eye_mm + Vec3d(point, 0.0)));
  const float weight = 1.0f / static_cast<float>(samples.x * samples.y * static_cast<int>(viewers.size()));
  Image picture(size.x, size.y, 3);
  pool.for_each(static_cast<std::size_t>(size.y), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < size.x; ++x) {
      Vec3f sum(0.0f);
      for (int j = 0; j < samples.y; ++j)
        for (int i = 0; i < samples.x; ++i) {
          const Vec2d at(x + (i + 0.5) / samples.x, y + (j + 0.5) / samples.y);
          for (const Viewer& viewer : viewers) sum += sampler.color(viewer, window.point_at(at, size));
        }
      float* pixel = picture.pixel(x, y);
      for (int c = 0; c < 3; ++c) pixel[c] = weight * sum[c];
    }
  });
  return picture;
}

double share_out_of_zone(const Optics& optics, const Viewer& viewer) {
  const RenderedPanel rendered{optics, {}};
  const Sampler sampler = make_sampler(rendered, {SampleFilter::kNearest, 0.0});
  const Window window = display_window(optics);
  const Vec2i grid = glm::min(lens_grid(optics), Vec2i(256));
  int outside = 0;
  for (int y = 0; y < grid.y; ++y)
    for (int x = 0; x < grid.x; ++x) {
      const Vec2d point = window.point_at({x + 0.5, y + 0.5}, grid);
      outside += std::visit([&](const auto& s) { return s.in_zone(viewer, point); }, sampler) ? 0 : 1;
    }
  return static_cast<double>(outside) / (static_cast<double>(grid.x) * grid.y);
}

}  // namespace lippmann
