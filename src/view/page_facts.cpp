#include "view/page_facts.hpp"

#include <algorithm>
#include <cmath>

#include "layout/cameras.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/layout/arrangement.hpp"
#include "lippmann/replay/eye_sampler.hpp"

namespace lippmann {
namespace {

/// Largest number of pixels of all views of a frame together. Computing 6 million pixels takes one to two seconds.
constexpr double kMaxEyePixels = 6e6;
constexpr int kMaxEyesAcross = 48, kMaxEyesUp = 9;

/// Arranges the views as tiles, at most about three times as wide as high, because textures have a maximum size. The last tiles
/// may stay empty.
ViewGrid tiles_for(int views) {
  const ViewGrid full = squarest_tiles(views);
  if (full.columns <= 3 * full.rows) return full;
  const int columns = static_cast<int>(std::ceil(std::sqrt(double(views))));
  return {columns, (views + columns - 1) / columns};
}

/// Describes the views of lenses that are not a whole number of pixels wide: one view per direction that the panel
/// distinguishes. Reduces the size of the views if they would exceed kMaxEyePixels.
void describe_eyes(const Optics& optics, PageFacts& facts) {
  const Vec2i counts = glm::min(view_counts(optics), Vec2i(kMaxEyesAcross, kMaxEyesUp));
  facts.grid = {counts.x, counts.y};
  const Vec2i size = natural_view_size(optics);
  const double share = kMaxEyePixels / (double(size.x) * size.y * facts.grid.count());
  facts.view_size = glm::max(Vec2i(Vec2d(size) * std::sqrt(std::min(share, 1.0))), Vec2i(1));
  facts.tiles = tiles_for(facts.grid.count());
  facts.panel = PanelPicture::kOwn;
}

void describe_views(const Optics& optics, const ViewLayout& film, PageFacts& facts) {
  facts.grid = film.grid;
  facts.view_size = view_size(film, picture_size(optics), "panel");
  const bool is_quilt = film.kind == LayoutKind::kQuilt;
  facts.tiles = is_quilt ? film.tiles : tiles_for(film.grid.count());
  facts.panel = film.kind == LayoutKind::kIntegral ? PanelPicture::kIntegral : PanelPicture::kQuilt;
  const std::optional<LensArray> lenses = lens_array(optics);
  facts.lens_samples_across = lenses.has_value();
  facts.lens_samples_up = lenses && lenses->row_pitch_mm > 0.0;
}

/// Returns whether every view has a pixel below every lens. A print may end within a lens.
bool has_whole_lenses(const ViewLayout& film, Vec2i picture) {
  return film.kind != LayoutKind::kIntegral || (picture.x % film.grid.columns == 0 && picture.y % film.grid.rows == 0);
}

Image eye_views_quilt(const RenderedPanel& rendered, const PageFacts& facts, const ThreadPool& pool, double crosstalk_px) {
  const Vec2i size = facts.view_size;
  const ViewGrid &grid = facts.grid, &tiles = facts.tiles;
  Image quilt(size.x * tiles.columns, size.y * tiles.rows, 3);
  const EyeSampler sampler(rendered, SampleFilter::kLinear, crosstalk_px);
  pool.for_each(static_cast<std::size_t>(grid.count() * size.y), [&](std::size_t line) {
    const int view = static_cast<int>(line) / size.y, y = static_cast<int>(line) % size.y;
    const Viewer viewer = eye_of_view(facts, view);
    const Vec2i origin(view % tiles.columns * size.x, (tiles.rows - 1 - view / tiles.columns) * size.y);
    for (int x = 0; x < size.x; ++x) {
      const Vec3f color = sampler.color(viewer, facts.window.point_at({x + 0.5, y + 0.5}, size));
      for (int c = 0; c < 3; ++c) quilt.pixel(origin.x + x, origin.y + y)[c] = color[c];
    }
  });
  return quilt;
}

}  // namespace

PageFacts page_facts(const Optics& optics) {
  PageFacts facts;
  const std::optional<RenderedViews> views = rendered_views(optics);
  if (views && has_whole_lenses(views->film, picture_size(optics)))
    describe_views(optics, views->film, facts);
  else
    describe_eyes(optics, facts);
  facts.window = display_window(optics);
  facts.axes = view_axes(optics, facts.grid);
  facts.eye_mm = default_eye_mm(optics);
  facts.panel_size = picture_size(optics);
  facts.phases = view_phases(optics);
  facts.depth_budget_mm = depth_budget_mm(optics);
  facts.disparity_scale_mm = facts.window.size.y;
  return facts;
}

Viewer eye_of_view(const PageFacts& facts, int view) {
  const int columns = facts.grid.columns;
  return {{facts.axes.across.slope(view % columns), facts.axes.up.slope(view / columns)}, facts.axes.vergence};
}

Image8 views_quilt(const RenderedPanel& rendered, const PageFacts& facts, const ThreadPool& pool, const std::string& where,
                   double crosstalk_px) {
  const ViewLayout quilt{LayoutKind::kQuilt, facts.grid, facts.tiles};
  const std::optional<RenderedViews> views = rendered_views(rendered.optics);
  if (!views || facts.panel == PanelPicture::kOwn)
    return to_codes(eye_views_quilt(rendered, facts, pool, crosstalk_px), Encoding::kSrgb);
  const Vec2i size(rendered.picture.width, rendered.picture.height);
  if (facts.panel == PanelPicture::kQuilt && size == picture_size(quilt, facts.view_size))
    return to_codes(rendered.picture, Encoding::kSrgb);
  return to_codes(Arrangement(views->film, quilt, size, where).apply(rendered.picture), Encoding::kSrgb);
}

}  // namespace lippmann
