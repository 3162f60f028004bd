#include "lippmann/replay/eye_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "lippmann/optics/viewing.hpp"
#include "optics/models.hpp"

namespace lippmann {
namespace {

constexpr double kPanelEdgePx = 1e-3;  ///< tolerance at the edges of the panel for rounding errors

struct Quality {
  SampleFilter filter;
  Vec2d crosstalk_px;  ///< sigma of the crosstalk between neighbouring pixels, along x and y

  bool blurs() const { return crosstalk_px != Vec2d(0.0); }
};

/// Returns the pixels and weights for interpolation along one axis, blurred if sigma_px > 0.
Taps blurred_taps(double position_px, double sigma_px, SampleFilter filter) {
  return sigma_px > 0.0 ? gaussian_taps(position_px, sigma_px) : taps_at(position_px, filter);
}

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
    const Taps columns = blurred_taps(q.x, quality_.crosstalk_px.x, quality_.filter);
    const Taps rows = blurred_taps(q.y, quality_.crosstalk_px.y, quality_.filter);
    const auto on_panel = [&](int x, int y) { return x >= 0 && y >= 0 && x < picture_.width && y < picture_.height; };
    if (quality_.blurs() || quality_.filter == SampleFilter::kNearest) return weighted_mean(picture_, columns, rows, on_panel);
    const CellOf cell = sight_.cell(q);
    const Vec3f mean = weighted_mean(picture_, columns, rows, [&](int x, int y) {
      return on_panel(x, y) && sight_.cell({x + 0.5, y + 0.5}) == cell;
    });
    return mean;
  }

  bool in_zone(const Viewer& viewer, Vec2d point_mm) const {
    constexpr double kFarAwayPx = 1e6;
    const PanelPoint seen = sight_.seen_from(viewer, point_mm);
    return sight_.cell(glm::clamp(seen.pixel, Vec2d(-kFarAwayPx), Vec2d(kFarAwayPx))) == seen.lens;
  }

 private:
  Sight sight_;
  const Image& picture_;
  Quality quality_;
};

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
    // Views are filtered like pixels: view v covers v to v + 1.
    const auto views = [&](int axis) {
      return blurred_taps(seen.view[axis] + 0.5, quality_.crosstalk_px[axis], quality_.filter);
    };
    const Vec2i count = sight_.views();
    Vec3f sum(0.0f);
    double weights = 0.0;
    for (const Tap& up : views(1))
      for (const Tap& across : views(0)) {
        const double weight = up.weight * across.weight;
        const Vec2i view(across.index, up.index);
        if (weight <= 0.0 || view.x < 0 || view.y < 0 || view.x >= count.x || view.y >= count.y) continue;
        sum += static_cast<float>(weight) * in_tile(view, columns, rows);
        weights += weight;
      }
    return weights > 0.0 ? sum / static_cast<float>(weights) : Vec3f(0.0f);
  }

  bool in_zone(const Viewer& viewer, Vec2d point_mm) const { return sight_.seen_from(viewer, point_mm).in_zone; }

 private:
  Vec3f in_tile(Vec2i view, Taps columns, Taps rows) const {
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

class SlantedSampler {
 public:
  SlantedSampler(const SlantedSight& sight, const RenderedPanel& rendered, const Quality& quality)
      : sight_(sight), picture_(rendered.picture), quality_(quality) {}

  Vec3f color(const Viewer& viewer, Vec2d point_mm) const {
    const Vec2d at = sight_.pixel_at(point_mm), size(sight_.size());
    for (int axis = 0; axis < 2; ++axis)
      if (!(at[axis] >= -kPanelEdgePx && at[axis] <= size[axis] + kPanelEdgePx)) return Vec3f(0.0f);
    Vec3f sum(0.0f);
    float weights = 0.0f;
    for (const Tap& row : taps_at(at.y, quality_.filter)) {
      if (row.weight <= 0.0 || row.index < 0 || row.index >= sight_.size().y) continue;
      const SlantedPoint seen = sight_.seen_from(viewer, point_mm, row.index);
      for (int c = 0; c < 3; ++c) sum[c] += static_cast<float>(row.weight) * in_row(seen, row.index, c, at.x);
      weights += static_cast<float>(row.weight);
    }
    return weights > 0.0f ? sum / weights : sum;
  }

  bool in_zone(const Viewer& viewer, Vec2d point_mm) const { return sight_.seen_from(viewer, point_mm, 0).in_zone; }

 private:
  /// Interpolates between the sub-pixels of one colour below one lens. If the filter covers no such sub-pixel, returns the
  /// nearest sub-pixel.
  float in_row(const SlantedPoint& seen, int row, int c, double near_column) const {
    const double column = std::clamp(sight_.column_of(seen, c, row, near_column), -1e6, 1e6);
    const bool blurred = quality_.blurs();
    const Taps taps = blurred_taps(column, quality_.crosstalk_px.x, quality_.filter);
    float sum = 0.0f, weights = 0.0f;
    for (const Tap& tap : taps) {
      if (tap.weight <= 0.0 || tap.index < 0 || tap.index >= picture_.width) continue;
      if (!blurred && sight_.lens_of(tap.index, row, c) != seen.lens) continue;
      sum += static_cast<float>(tap.weight) * picture_.pixel(tap.index, row)[c];
      weights += static_cast<float>(tap.weight);
    }
    if (weights > 0.0f) return sum / weights;
    return picture_.pixel(std::clamp(static_cast<int>(std::floor(column)), 0, picture_.width - 1), row)[c];
  }

  SlantedSight sight_;
  const Image& picture_;
  Quality quality_;
};

using Sampler = std::variant<SlantedSampler, LensSampler<LenticularSight>, LensSampler<MicrolensSight>, QuiltSampler>;

template <class Sight>
LensSampler<Sight> sampler_of(const Sight& sight, const RenderedPanel& rendered, const Quality& quality) {
  return {sight, rendered, quality};
}
SlantedSampler sampler_of(const SlantedSight& sight, const RenderedPanel& rendered, const Quality& quality) {
  return {sight, rendered, quality};
}
QuiltSampler sampler_of(const QuiltSight& sight, const RenderedPanel& rendered, const Quality& quality) {
  return {sight, rendered, quality};
}

Sampler make_sampler(const RenderedPanel& rendered, const Quality& quality) {
  return std::visit([&](const auto& sight) -> Sampler { return sampler_of(sight, rendered, quality); },
                    make_sight(rendered.optics));
}

}  // namespace

struct EyeSampler::Impl {
  Sampler sampler;
};

namespace {

const RenderedPanel& checked(const RenderedPanel& rendered) {
  validate(rendered);
  return rendered;
}

}  // namespace

EyeSampler::EyeSampler(const RenderedPanel& rendered, SampleFilter filter, double crosstalk_px)
    : impl_(std::make_unique<Impl>(
          Impl{make_sampler(checked(rendered), {filter, crosstalk_sigmas(rendered.optics, crosstalk_px)})})) {}
EyeSampler::~EyeSampler() = default;
EyeSampler::EyeSampler(EyeSampler&&) noexcept = default;

Vec3f EyeSampler::color(const Viewer& viewer, Vec2d point_mm) const {
  return std::visit([&](const auto& sampler) { return sampler.color(viewer, point_mm); }, impl_->sampler);
}

double share_out_of_zone(const Optics& optics, const Viewer& viewer) {
  const RenderedPanel nothing{optics, {}};
  const Sampler sampler = make_sampler(nothing, {SampleFilter::kNearest, Vec2d(0.0)});
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
