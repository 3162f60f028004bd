#include "job/panel_size.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr int kDefaultLenses = 64;
constexpr float kDefaultLensPixels = 8.0f;
constexpr int kDefaultTile = 256;            ///< pixels of a view in a quilt, both ways
constexpr int kDefaultSingle = 512;          ///< pixels of a single view, both ways
constexpr float kHexagonalRow = 0.8660254f;  ///< rows of hexagonally packed lenses are this fraction of a pitch apart

/// Whole pixels that `lenses` cells of `pixels` cover; at least 1, clamped so that absurd sizes stay representable.
int covered_pixels(int lenses, float pixels) {
  const double product = static_cast<double>(lenses) * static_cast<double>(pixels);
  return static_cast<int>(std::clamp(std::round(product), 1.0, 2147483647.0));
}

/// Throws unless `lenses` cells of `pixels` cover `size`, to the pixel.
void require_agreement(int size, int lenses, float pixels, const char* direction) {
  if (std::abs(static_cast<float>(lenses) * pixels - static_cast<float>(size)) < 1.0f) return;
  throw usage_error("--size",
                    fmt::format("{} pixels {}, but {} lenses of {} pixels make {}", size, direction, lenses, pixels,
                                covered_pixels(lenses, pixels)),
                    "two of --size, --lenses and --lens-pixels, or three that agree");
}

/// Pixels below a lens, across: those of the parameters, or the share of a lens in the size they give, or the default.
float lens_pixels_across(const RenderParams& params) {
  const int size = params.optics.size.x, lenses = params.optics.lenses.x;
  const float pixels = params.optics.lens_pixels.x;
  if (pixels > 0.0f && size > 0 && lenses > 0) require_agreement(size, lenses, pixels, "across");
  if (pixels > 0.0f) return pixels;
  if (size == 0 || lenses == 0) return kDefaultLensPixels;
  if (size < lenses)
    throw usage_error("--lenses", fmt::format("{} lenses on {} pixels", lenses, size),
                      fmt::format("1 to {}: a lens covers at least one pixel", size));
  return static_cast<float>(size) / static_cast<float>(lenses);
}

/// Lenses have no extent along a lenticular sheet: numbers down only say how high the panel is.
PanelSize lenticular_size(const RenderParams& params) {
  const float pixels = lens_pixels_across(params);
  if (params.optics.size.x > 0) return {params.optics.size.x, params.optics.size.y, pixels};
  const int lenses = params.optics.lenses.x > 0 ? params.optics.lenses.x : kDefaultLenses;
  return {covered_pixels(lenses, pixels),
          covered_pixels(params.optics.lenses.y > 0 ? params.optics.lenses.y : lenses,
                         params.optics.lens_pixels.y > 0.0f ? params.optics.lens_pixels.y : pixels),
          pixels};
}

/// Lenslets are round: as many pixels down as across.
PanelSize microlens_size(const RenderParams& params) {
  const float pixels = lens_pixels_across(params);
  if (params.optics.lens_pixels.y > 0.0f && params.optics.lens_pixels.y != pixels)
    throw usage_error("--lens-pixels", fmt::format("{} pixels across but {} down", pixels, params.optics.lens_pixels.y),
                      "the same number both ways: lenslets are round");
  const float row_pixels = params.optics.packing == LensPacking::kHexagonal ? pixels * kHexagonalRow : pixels;
  if (params.optics.size.x > 0) {
    if (params.optics.lenses.y > 0) require_agreement(params.optics.size.y, params.optics.lenses.y, row_pixels, "down");
    return {params.optics.size.x, params.optics.size.y, pixels};
  }
  const int lenses = params.optics.lenses.x > 0 ? params.optics.lenses.x : kDefaultLenses;
  return {covered_pixels(lenses, pixels),
          covered_pixels(params.optics.lenses.y > 0 ? params.optics.lenses.y : lenses, row_pixels), pixels};
}

PanelSize quilt_size(const RenderParams& params) {
  const Extent<int> views = quilt_views(params);
  if (params.optics.size.x == 0) return {covered_pixels(views.x, kDefaultTile), covered_pixels(views.y, kDefaultTile), 0.0f};
  if (params.optics.size.x % views.x != 0 || params.optics.size.y % views.y != 0)
    throw usage_error("--size",
                      fmt::format("{}x{} pixels do not divide into --views {}x{}", params.optics.size.x, params.optics.size.y,
                                  views.x, views.y),
                      fmt::format("for example {}x{}", std::max(1, params.optics.size.x / views.x) * views.x,
                                  std::max(1, params.optics.size.y / views.y) * views.y));
  return {params.optics.size.x, params.optics.size.y, 0.0f};
}

PanelSize single_size(const RenderParams& params, Vec2i scene_resolution) {
  if (params.optics.size.x > 0) return {params.optics.size.x, params.optics.size.y, 0.0f};
  if (scene_resolution.x > 0 && scene_resolution.y > 0) return {scene_resolution.x, scene_resolution.y, 0.0f};
  return {kDefaultSingle, kDefaultSingle, 0.0f};
}

void refuse(bool given, const char* flag, const char* accepted) {
  if (given) throw usage_error(flag, "has no effect on this kind of optics", accepted);
}

/// A flag that would change nothing is the caller's mistake, which we don't overlook.
void refuse_what_has_no_meaning(const RenderParams& params) {
  const bool lenticular = optics_kind(params) == OpticsKind::kLenticular,
             microlens = optics_kind(params) == OpticsKind::kMicrolens;
  refuse(params.optics.slant_deg != 0.0f && !lenticular, "--slant", "with --optics lenticular");
  refuse(params.optics.packing != LensPacking::kSquare && !microlens, "--packing", "with --optics microlens");
  refuse(params.optics.lenses.x > 0 && !lenticular && !microlens, "--lenses", "with --optics lenticular or microlens");
  refuse(params.optics.lens_pixels.x > 0.0f && !lenticular && !microlens, "--lens-pixels",
         "with --optics lenticular or microlens");
  refuse(params.optics.camera_grid && optics_kind(params) != OpticsKind::kMultiview, "--camera-grid",
         "with --optics multiview");
  refuse(params.optics.views.x > 0 && optics_kind(params) != OpticsKind::kMultiview, "--views", "with --optics multiview");
}

PanelSize size_of_kind(const RenderParams& params, Vec2i scene_resolution) {
  switch (optics_kind(params)) {
    case OpticsKind::kLenticular:
      return lenticular_size(params);
    case OpticsKind::kMicrolens:
      return microlens_size(params);
    case OpticsKind::kMultiview:
      return quilt_size(params);
    case OpticsKind::kSingle:
      break;
  }
  return single_size(params, scene_resolution);
}

}  // namespace

Extent<int> quilt_views(const RenderParams& params) {
  return params.optics.views.x > 0 ? params.optics.views : Extent<int>{8, 6};
}

PanelSize panel_size(const RenderParams& params, Vec2i scene_resolution) {
  refuse_what_has_no_meaning(params);
  const PanelSize size = size_of_kind(params, scene_resolution);
  const std::int64_t pixels = std::int64_t{size.width} * size.height;
  if (pixels > kMaxPixels || std::max(size.width, size.height) > kMaxSide)
    throw usage_error("--size, --lenses, --lens-pixels",
                      fmt::format("a picture of {}x{} = {} pixels", size.width, size.height, pixels),
                      fmt::format("1 to {} pixels, at most {} a side", kMaxPixels, kMaxSide));
  return size;
}

}  // namespace lippmann
