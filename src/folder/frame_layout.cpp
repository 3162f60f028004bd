#include "folder/frame_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "folder/frame_files.hpp"
#include "formats/quad_name.hpp"
#include "formats/rgbd_name.hpp"
#include "image/tiff.hpp"
#include "layout/film_layout.hpp"
#include "layout/sub_pixels.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::int64_t kMaxFilePixels = std::int64_t{1} << 28;

ViewLayout wanted_layout(const PictureParams& params, PictureLayout layout, const ViewLayout& film) {
  const ViewGrid& grid = film.grid;
  if (layout == PictureLayout::kIntegral) return {LayoutKind::kIntegral, grid, {}};
  if (layout == PictureLayout::kViews) return {LayoutKind::kStack, grid, {}};
  ViewGrid tiles{params.quilt.x, params.quilt.y};
  if (params.quilt.x == 0) {
    tiles = grid.rows > 1 ? grid : squarest_tiles(grid.count());
    if (film.kind == LayoutKind::kQuilt) tiles = film.tiles;
  }
  if (tiles.count() != grid.count())
    throw usage_error("quilt", fmt::format("{}x{} tiles do not hold {} views", tiles.columns, tiles.rows, grid.count()),
                      "as many tiles as there are views");
  return {LayoutKind::kQuilt, grid, tiles};
}

bool same_places(const ViewLayout& a, const ViewLayout& b) {
  return a.kind == b.kind && (a.kind != LayoutKind::kQuilt || a.tiles == b.tiles);
}

/// Width / height of the visible part of the display plane.
double display_aspect(const Optics& optics) {
  const Vec2f window = window_size_mm(optics);
  return static_cast<double>(window.x) / window.y;
}

/// Returns the quilt layout if the optics render the views of a display's quilt, otherwise the layout of integral images.
PictureLayout default_layout(const Optics& optics, const Display* display) {
  const bool is_quilt = display && view_tiles(optics);
  return is_quilt ? PictureLayout::kQuilt : PictureLayout::kIntegral;
}

void refuse_without(bool has_other, bool given, const char* name, const char* other) {
  if (given && !has_other) throw usage_error(name, fmt::format("has no effect without {}", other), other);
}

std::optional<PictureLayout> layout_named(const std::string& format) {
  if (format == "integral") return PictureLayout::kIntegral;
  if (format == "quilt") return PictureLayout::kQuilt;
  if (format == "views") return PictureLayout::kViews;
  if (format == "native") return PictureLayout::kNative;
  if (format == "stereo") return PictureLayout::kStereo;
  if (format == "rgbd") return PictureLayout::kRgbd;
  return std::nullopt;
}

/// Returns the parameters with the layout that `to` names, or unchanged if `to` does not name one.
PictureParams with_layout(PictureParams params) {
  if (params.layout == PictureLayout::kRgbd && params.to.empty()) params.to = "rgbd";
  if (params.to.empty()) return params;
  find_output_format(params.to, "to");
  const std::optional<PictureLayout> layout = layout_named(params.to);
  if (params.layout && params.layout != layout)
    throw usage_error("to", fmt::format("{} cannot be combined with `layout`", params.to), "one of the two");
  if (layout && layout != PictureLayout::kRgbd) params.layout = layout, params.to.clear();
  return params;
}

void refuse_depth_params(const PictureParams& params) {
  const bool is_rgbd = params.to == kRgbdFormat;
  refuse_without(is_rgbd, params.depth.range.has_value(), "depth-range", "`layout` rgbd");
  refuse_without(is_rgbd, params.depth.linear.has_value(), "depth-coding", "`layout` rgbd");
  refuse_without(is_rgbd, params.depth.near_black, "near-black", "`layout` rgbd");
}

Image mirrored(const Image& image) {
  Image mirror(image.width, image.height, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(image.pixel(image.width - 1 - x, y), image.channels, mirror.pixel(x, y));
  return mirror;
}

}  // namespace

FrameLayout::FrameLayout(const PictureParams& wanted, const Optics& optics, const Display* display)
    : film_(film_size(optics)), sub_pixels_(sub_pixels_per_pixel(optics) > 1) {
  const PictureParams params = with_layout(wanted);
  const PictureLayout layout = params.layout.value_or(default_layout(optics, display));
  const bool is_print = layout == PictureLayout::kPrint;
  format_ = is_print ? PictureFormat::kTiff : params.format;
  names_.ending = ending_of(format_);
  refuse_without(layout == PictureLayout::kQuilt, params.quilt.x > 0, "quilt", "`layout` quilt");
  refuse_without(is_print, params.mirror, "mirror", "`layout` print");
  refuse_without(display != nullptr, layout == PictureLayout::kNative || is_print, "`layout` native or print", "a `display`");
  const bool is_stereo = layout == PictureLayout::kStereo;
  refuse_without(is_stereo, params.stereo.packing != StereoPacking::kSideBySide, "stereo", "`layout` stereo");
  refuse_without(is_stereo, params.stereo.right_first, "right-first", "`layout` stereo");
  refuse_depth_params(params);
  mirrors_ = params.mirror;
  if (display) pixels_per_mm_ = 1.0 / display->pixel_mm();
  if (params.pseudoscopic) {
    turn_round(optics, layout);
    return;
  }
  if (!params.to.empty()) {
    use_format(find_output_format(params.to, "to"), optics);
    return;
  }
  if (layout == PictureLayout::kStereo) {
    pair_views(params.stereo, optics);
    return;
  }
  if (layout == PictureLayout::kNative || is_print || (layout == PictureLayout::kIntegral && has_lenses(optics))) {
    if (!sub_pixels_ && !has_lenses(optics))
      throw usage_error("layout", "a native frame needs the display's own optics", "`layout` native without `optics`");
    return;
  }
  if (!params.layout && !display) return;
  if (is_single_view(optics) && !params.layout) return;
  arrange_views(params, layout, optics);
}

void FrameLayout::check_picture_size(bool with_layers) const {
  const Vec2i size = picture_size();
  const std::int64_t pixels = std::int64_t{size.x} * size.y;
  if ((format_ == PictureFormat::kTiff && !with_layers) || pixels <= kMaxFilePixels) return;
  throw usage_error(
      "format", fmt::format("pictures of {}x{} = {} pixels are too large for PNG and EXR files", size.x, size.y, pixels),
      fmt::format("up to {} pixels, or `format` tiff (`layout` print) without `aov` up to {}", kMaxFilePixels, kMaxTiffPixels));
}

/// Rotates every elemental image by 180 degrees, as a recording lens array does (docs/guide/replay.md).
void FrameLayout::turn_round(const Optics& optics, PictureLayout layout) {
  if (layout != PictureLayout::kIntegral || !has_lenses(optics))
    throw usage_error("pseudoscopic", "needs elemental images, which only pictures behind lenses have", "`layout` integral");
  const ViewLayout film = film_layout(optics, "pseudoscopic");
  arrangement_.emplace(film, ViewLayout{LayoutKind::kEslf, film.grid, {}}, film_, "pseudoscopic");
}

void FrameLayout::use_format(const LightFieldFormat& format, const Optics& optics) {
  const ViewLayout film = is_single_view(optics) ? ViewLayout{LayoutKind::kStack, {1, 1}, {}} : film_layout(optics, "to");
  light_field_ = &format;
  names_.is_folder = format.is_folder;
  is_rgbd_ = format.name == kRgbdFormat;
  if (is_rgbd_) names_.suffix = kRgbdEnding;
  if (format.name == kQuadFormat) names_.suffix = kQuadEnding;
  if (format_ == PictureFormat::kTiff) throw usage_error("format", "light-field formats do not use TIFF", "png, png16 or exr");
  view_size_ = view_size(film, film_, "to");
  if (format.is_folder) pictures_per_frame_ = film.grid.count();
}

void FrameLayout::arrange_views(const PictureParams& params, PictureLayout layout, const Optics& optics) {
  const ViewLayout film = film_layout(optics, "layout"), wanted = wanted_layout(params, layout, film);
  if (wanted.kind == LayoutKind::kQuilt) {
    quilt_ = {{wanted.tiles, display_aspect(optics)}, wanted.grid.count(), false, wanted.grid};
    names_.suffix = quilt_ending(quilt_->quilt);
  }
  if (wanted.kind == LayoutKind::kStack) {
    names_.views = pictures_per_frame_ = film.grid.count();
  }
  if (!same_places(film, wanted)) arrangement_.emplace(film, wanted, film_, "layout");
}

/// If the stereo layout squeezes the views, the film already holds squeezed views.
void FrameLayout::pair_views(const StereoLayout& layout, const Optics& optics) {
  const ViewLayout film = film_layout(optics, "layout");
  if (film.kind != LayoutKind::kQuilt || film.grid != ViewGrid{2, 1})
    throw usage_error("layout", "stereo cannot be combined with `optics`: a stereo picture is rendered for two eyes",
                      "`layout` stereo without `optics`");
  const Vec2i stored = view_size(film, film_, "layout");
  const std::vector<std::uint32_t> film_pixels = pixels_of_views(film, stored, film_);
  stereo_ = layout;
  stereo_size_ = stereo_picture_size(layout.packing, stored);
  stereo_pixels_ = lippmann::stereo_pixels(layout, stored);
  for (std::uint32_t& pixel : stereo_pixels_) pixel = film_pixels[pixel];
  names_.suffix = stereo_ending(layout);
}

Vec2i FrameLayout::picture_size() const {
  if (stereo_) return stereo_size_;
  if (is_rgbd_) return {2 * view_size_.x, view_size_.y};
  if (light_field_ && light_field_->name == kQuadFormat) return 2 * view_size_;
  if (light_field_) return light_field_->is_folder ? view_size_ : film_;
  if (sub_pixels_) return {film_.x / 3, film_.y};
  if (!arrangement_) return film_;
  return names_.views > 0 ? arrangement_->view_size() : arrangement_->target_size();
}

std::filesystem::path FrameLayout::video_path(const std::filesystem::path& plain) const {
  if (stereo_) return with_stereo_name(plain, *stereo_);
  if (is_rgbd_) return with_rgbd_name(plain);
  return quilt_ ? with_quilt_name(plain, quilt_->quilt) : plain;
}

Image FrameLayout::arrange(const Image& film) const {
  if (stereo_) {
    Image picture(stereo_size_.x, stereo_size_.y, film.channels);
    move_pixels(film, stereo_pixels_, picture, {});
    return picture;
  }
  if (sub_pixels_) return join_sub_pixels(film);
  if (mirrors_) return mirrored(film);
  return arrangement_ ? arrangement_->apply(film) : film;
}

void FrameLayout::arrange(FrameAovs& aovs) const {
  for (std::size_t i = 0; i < kAovs; ++i) {
    if (!aovs.wanted[i]) continue;
    // Layers of light have separate colours for sub-pixels; all other layers have one value per pixel.
    const bool whole_pixels = sub_pixels_ && !is_light(static_cast<Aov>(i));
    aovs.images[i] = whole_pixels ? middle_sub_pixels(aovs.images[i]) : arrange(aovs.images[i]);
  }
  if (mirrors_ && aovs.wants(Aov::kMotion))
    for (std::size_t i = 0; i < aovs[Aov::kMotion].data.size(); i += 2) aovs[Aov::kMotion].data[i] *= -1.0f;
}

}  // namespace lippmann
