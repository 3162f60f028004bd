#include "render/frame_layout.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace lippmann {
namespace {

/// The views as they lie in a film.
ViewLayout film_layout(const Optics& optics) {
  if (const auto* views = std::get_if<MultiView>(&optics.model)) {
    const ViewGrid tiles{views->columns, views->rows};
    return {LayoutKind::kQuilt, views->baseline_mm > 0.0f ? tiles : ViewGrid{tiles.count(), 1}, tiles};
  }
  const Vec2i n = whole_pixels_per_lens(optics);
  if (n.x > 0) return {LayoutKind::kIntegral, {n.x, n.y}, {}};
  throw usage_error("--layout", "lenses that do not have a whole number of pixels make no views",
                    "--layout integral, or whole --lens-pixels without --slant or hexagonal --packing");
}

ViewLayout wanted_layout(const RenderParams& params, const ViewLayout& film) {
  const ViewGrid& grid = film.grid;
  switch (*params.layout) {
    case PictureLayout::kIntegral:
      return {LayoutKind::kIntegral, grid, {}};
    case PictureLayout::kViews:
      return {LayoutKind::kStack, grid, {}};
    case PictureLayout::kQuilt:
      break;
  }
  ViewGrid tiles{params.quilt.x, params.quilt.y};
  if (params.quilt.x == 0) {
    tiles = grid.rows > 1 ? grid : squarest_tiles(grid.count());
    if (film.kind == LayoutKind::kQuilt) tiles = film.tiles;
  }
  if (tiles.count() != grid.count())
    throw usage_error("--quilt",
                      fmt::format("{}x{} tiles are not as many as {} views", tiles.columns, tiles.rows, grid.count()),
                      "as many tiles as the optics have views");
  return {LayoutKind::kQuilt, grid, tiles};
}

bool same_places(const ViewLayout& a, const ViewLayout& b) {
  return a.kind == b.kind && (a.kind != LayoutKind::kQuilt || a.tiles == b.tiles);
}

/// Width / height of what is seen of the display plane.
double display_aspect(const Optics& optics) {
  const Vec2f window = window_size_mm(optics);
  return static_cast<double>(window.x) / window.y;
}

}  // namespace

FrameLayout::FrameLayout(const RenderParams& params, const Optics& optics) : film_(optics.panel.width, optics.panel.height) {
  names_.format = params.format;
  if (params.quilt.x > 0 && params.layout != PictureLayout::kQuilt)
    throw usage_error("--quilt", "means nothing without a quilt", "it together with --layout quilt");
  if (!params.layout) return;
  const bool lenses =
      std::holds_alternative<LenticularSheet>(optics.model) || std::holds_alternative<MicrolensArray>(optics.model);
  if (params.layout == PictureLayout::kIntegral && lenses) return;
  const ViewLayout film = film_layout(optics), wanted = wanted_layout(params, film);
  if (wanted.kind == LayoutKind::kQuilt) {
    quilt_ = {wanted.tiles, display_aspect(optics)};
    names_.quilt = quilt_ending(*quilt_);
  }
  if (wanted.kind == LayoutKind::kStack) {
    names_.views = film.grid.count();
    if (!params.video.empty()) throw usage_error("--video", "views are pictures of their own", "--layout quilt or integral");
  }
  if (!same_places(film, wanted)) arrangement_.emplace(film, wanted, film_, "--layout");
}

Vec2i FrameLayout::picture_size() const {
  if (!arrangement_) return film_;
  return names_.views > 0 ? arrangement_->view_size() : arrangement_->target_size();
}

std::filesystem::path FrameLayout::video_path(const std::filesystem::path& said) const {
  return quilt_ ? with_quilt_name(said, *quilt_) : said;
}

Image FrameLayout::arrange(const Image& film) const { return arrangement_ ? arrangement_->apply(film) : film; }

void FrameLayout::arrange(FrameAovs& aovs) const {
  for (Image FrameAovs::*const layer :
       {&FrameAovs::depth_image, &FrameAovs::normal_image, &FrameAovs::object_id_image, &FrameAovs::position_image})
    if (!(aovs.*layer).data.empty()) aovs.*layer = arrange(aovs.*layer);
}

}  // namespace lippmann
