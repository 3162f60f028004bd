#include "job/frame_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "image/tiff.hpp"
#include "layout/film_layout.hpp"
#include "layout/sub_pixels.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::int64_t kMaxFilePixels = std::int64_t{1} << 28;  ///< that PNG and EXR files are written and read with

ViewLayout wanted_layout(const RenderParams& params, PictureLayout layout, const ViewLayout& film) {
  const ViewGrid& grid = film.grid;
  if (layout == PictureLayout::kIntegral) return {LayoutKind::kIntegral, grid, {}};
  if (layout == PictureLayout::kViews) return {LayoutKind::kStack, grid, {}};
  ViewGrid tiles{params.output.quilt.x, params.output.quilt.y};
  if (params.output.quilt.x == 0) {
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

/// Quilts for displays are called quilts.
PictureLayout default_layout(const Optics& optics, const Display* display) {
  const bool is_quilt = display && std::holds_alternative<MultiView>(optics.model);
  return is_quilt ? PictureLayout::kQuilt : PictureLayout::kIntegral;
}

void refuse_without(bool given, bool said, const char* flag, const char* other) {
  if (said && !given) throw usage_error(flag, fmt::format("means nothing without {}", other), "both, or neither");
}

/// Left and right exchanged.
Image mirrored(const Image& image) {
  Image mirror(image.width, image.height, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(image.pixel(image.width - 1 - x, y), image.channels, mirror.pixel(x, y));
  return mirror;
}

}  // namespace

FrameLayout::FrameLayout(const RenderParams& params, const Optics& optics, const Display* display)
    : film_(optics.panel.width, optics.panel.height), sub_pixels_(std::holds_alternative<SlantedPanel>(optics.model)) {
  const PictureLayout layout = params.output.layout.value_or(default_layout(optics, display));
  const bool is_print = layout == PictureLayout::kPrint;
  names_.format = is_print ? PictureFormat::kTiff : params.output.format;
  refuse_without(layout == PictureLayout::kQuilt, params.output.quilt.x > 0, "--quilt", "--layout quilt");
  refuse_without(is_print, params.output.mirror, "--mirror", "--layout print");
  refuse_without(display != nullptr, layout == PictureLayout::kNative || is_print, "--layout native or print", "--display");
  mirrors_ = params.output.mirror;
  if (display) pixels_per_mm_ = 1.0 / display->pixel_mm();
  if (params.output.pseudoscopic) {
    turn_round(optics, layout);
    return;
  }
  if (layout == PictureLayout::kNative || is_print || (layout == PictureLayout::kIntegral && has_lenses(optics))) {
    if (!sub_pixels_ && !has_lenses(optics))
      throw usage_error("--layout", "the display's own frame is neither a quilt nor a single view",
                        "--layout without --optics");
    return;
  }
  if (!params.output.layout && !display) return;
  if (std::holds_alternative<SingleView>(optics.model) && !params.output.layout) return;
  arrange_views(params, layout, optics);
}

void FrameLayout::check_picture_size(bool with_layers) const {
  const Vec2i size = picture_size();
  const std::int64_t pixels = std::int64_t{size.x} * size.y;
  if ((names_.format == PictureFormat::kTiff && !with_layers) || pixels <= kMaxFilePixels) return;
  throw usage_error(
      "--format", fmt::format("pictures of {}x{} = {} pixels are too large for PNG and EXR files", size.x, size.y, pixels),
      fmt::format("up to {} pixels, or --format tiff (--layout print) without --aov up to {}", kMaxFilePixels, kMaxTiffPixels));
}

/// A recording array turns every elemental image by 180 degrees (docs/replay.md): a layout that is not turned round.
void FrameLayout::turn_round(const Optics& optics, PictureLayout layout) {
  if (layout != PictureLayout::kIntegral || !has_lenses(optics))
    throw usage_error("--pseudoscopic", "only what lies behind lenses can be turned round", "--layout integral");
  const ViewLayout film = film_layout(optics, "--pseudoscopic");
  arrangement_.emplace(film, ViewLayout{LayoutKind::kEslf, film.grid, {}}, film_, "--pseudoscopic");
}

void FrameLayout::arrange_views(const RenderParams& params, PictureLayout layout, const Optics& optics) {
  const ViewLayout film = film_layout(optics, "--layout"), wanted = wanted_layout(params, layout, film);
  if (wanted.kind == LayoutKind::kQuilt) {
    quilt_ = {wanted.tiles, display_aspect(optics)};
    names_.quilt = quilt_ending(*quilt_);
  }
  if (wanted.kind == LayoutKind::kStack) {
    names_.views = film.grid.count();
    if (!params.output.video.empty())
      throw usage_error("--video", "views are pictures of their own", "--layout quilt or integral");
  }
  if (!same_places(film, wanted)) arrangement_.emplace(film, wanted, film_, "--layout");
}

Vec2i FrameLayout::picture_size() const {
  if (sub_pixels_) return {film_.x / 3, film_.y};
  if (!arrangement_) return film_;
  return names_.views > 0 ? arrangement_->view_size() : arrangement_->target_size();
}

std::filesystem::path FrameLayout::video_path(const std::filesystem::path& said) const {
  return quilt_ ? with_quilt_name(said, *quilt_) : said;
}

Image FrameLayout::arrange(const Image& film) const {
  if (sub_pixels_) return join_sub_pixels(film);
  if (mirrors_) return mirrored(film);
  return arrangement_ ? arrangement_->apply(film) : film;
}

void FrameLayout::arrange(FrameAovs& aovs) const {
  for (std::size_t i = 0; i < kAovs; ++i) {
    if (!aovs.wanted[i]) continue;
    const bool whole_pixels = sub_pixels_ && !is_light(static_cast<Aov>(i));  // light has the sub-pixels' colours
    aovs.images[i] = whole_pixels ? middle_sub_pixels(aovs.images[i]) : arrange(aovs.images[i]);
  }
  if (mirrors_ && aovs.wants(Aov::kMotion))
    for (std::size_t i = 0; i < aovs[Aov::kMotion].data.size(); i += 2) aovs[Aov::kMotion].data[i] *= -1.0f;
}

}  // namespace lippmann
