#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/resample_light.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/display_picture.hpp"
#include "lippmann/optics/viewing.hpp"

namespace lippmann {
namespace {

/// Relative difference below which aspect ratios count as equal.
constexpr double kSameAspect = 0.01;

/// The samples of a view along one row of a display's lenses. `first`: left edge of the first sample. `step`: width of a
/// sample. Both are fractions of the display's width.
struct RowOfSamples {
  int count;
  double first, step;
};

/// One sample per vertical lens, at the strip below the lens. Slanted lenses cross pixel columns, so they have two
/// samples per lens.
RowOfSamples samples_of_sheet(const Display& display) {
  const LensStrips strips = lens_strips(display);
  const double width = display.pixels.x;
  if (strips.sine != 0.0) {
    const int count = 2 * static_cast<int>(std::ceil(width * strips.cosine / strips.cell_px));
    return {count, 0.0, 1.0 / count};
  }
  constexpr double kRounding = 1e-6;
  const int count = static_cast<int>(std::ceil((width - strips.start_px) / strips.cell_px - kRounding));
  return {count, strips.start_px / width, strips.cell_px / width};
}

void check_strips(const Display& display) {
  const double cell = lens_strips(display).cell_px;
  constexpr double kRoundingPx = 1e-6;
  if (cell >= 2.0 - kRoundingPx && cell <= display.pixels.x + kRoundingPx) return;
  throw usage_error(
      "display",
      fmt::format("lenses are {:.3f} pixels wide on a picture of {}x{} pixels", cell, display.pixels.x, display.pixels.y),
      "a lens pitch from 2 pixels to the width of the picture");
}

Vec2i tile_of(const DisplayQuilt& quilt) { return {quilt.width / quilt.columns, quilt.height / quilt.rows}; }

}  // namespace

AspectFit default_fit(DisplayTarget target) {
  return target == DisplayTarget::kNative ? AspectFit::kStretch : AspectFit::kCrop;
}

ViewFitter::ViewFitter(const Display& display, DisplayTarget target, AspectFit fit, const ThreadPool& pool,
                       double view_shift_px)
    : display_(display), target_(target), fit_(fit), pool_(pool), view_shift_px_(view_shift_px) {
  aspect_ = static_cast<double>(display.pixels.x) / display.pixels.y;
  if (target == DisplayTarget::kQuilt) aspect_ = display.quilt->aspect;
  if (target != DisplayTarget::kIntegral) {
    size_ = display.quilt ? tile_of(*display.quilt) : (display.pixels + 1) / 2;
    step_ = 1.0 / size_.x;
  } else if (display.kind == DisplayKind::kLenticularSheet) {
    check_strips(display);
    const RowOfSamples row = samples_of_sheet(display);
    size_ = {row.count, display.pixels.y};
    first_ = row.first, step_ = row.step;
    lenses_ = display.pixels.x / lens_strips(display).cell_px;
  } else {
    size_ = lens_grid(native_optics(display));
    lenses_ = size_.x;
    step_ = 1.0 / size_.x;
  }
}

/// Size of the part of a view that fills the display, in pixels of the view. It is larger than the view if the view is
/// padded.
Vec2d ViewFitter::window_of(Vec2i view, double aspect) const {
  const double excess = aspect / aspect_;
  const bool is_tile = target_ != DisplayTarget::kIntegral && view == size_;
  if (fit_ == AspectFit::kStretch || is_tile || std::abs(excess - 1.0) < kSameAspect) return view;
  const bool is_too_wide = excess > 1.0;
  if ((fit_ == AspectFit::kCrop) == is_too_wide) return {view.x / excess, view.y};
  return {view.x, view.y * excess};
}

/// Returns the part of window_of() that all views contain after each is shifted by view_shift_px_ relative to its neighbour.
/// With kPad, returns the whole window_of().
Vec2d ViewFitter::window_in_all(Vec2i view, double aspect, ViewGrid grid) const {
  Vec2d window = window_of(view, aspect);
  const Vec2d left = Vec2d(view) - std::abs(view_shift_px_) * Vec2d(grid.columns - 1, grid.rows - 1);
  if (left.x < 0.5 * view.x || left.y < 0.5 * view.y)
    throw usage_error("view-shift",
                      fmt::format("{:.4g} pixels from view to view leave less than half of {}x{} views of {}x{} pixels",
                                  view_shift_px_, grid.columns, grid.rows, view.x, view.y),
                      "a smaller shift");
  if (fit_ == AspectFit::kPad) return window;
  const Vec2d share = glm::min(left / window, Vec2d(1.0));
  window *= fit_ == AspectFit::kStretch ? share : Vec2d(std::min(share.x, share.y));
  return window;
}

Picture ViewFitter::fitted(const Picture& view, double aspect, int number, ViewGrid grid) {
  const Vec2i from = size_of(view);
  if (has_fitted() && from != original_)
    throw Error("views",
                fmt::format("one view has {}x{} pixels, but other views have {}x{}", from.x, from.y, original_.x, original_.y),
                "views of one size");
  original_ = from, window_ = window_in_all(from, aspect, grid);
  const bool is_whole = window_ == Vec2d(from) && view_shift_px_ == 0.0;
  // An interlaced (native) frame can be made from views of any size. Therefore a whole view is not resized if it is not larger
  // than the display, or if views are stretched.
  const bool is_small = from.x <= display_.pixels.x && from.y <= display_.pixels.y;
  if (target_ == DisplayTarget::kNative && is_whole && (is_small || fit_ == AspectFit::kStretch)) {
    size_ = from;
    return view;
  }
  if (is_whole && from == size_ && first_ == 0.0) return view;
  const bool pads = fit_ == AspectFit::kPad;
  const Vec2d place = Vec2d(number % grid.columns, number / grid.columns) - 0.5 * Vec2d(grid.columns - 1, grid.rows - 1);
  const Vec2d corner = 0.5 * (Vec2d(from) - window_) + view_shift_px_ * place * Vec2d(1.0, -1.0);
  const AxisSamples across{corner.x + first_ * window_.x, step_ * window_.x, size_.x, pads};
  const AxisSamples down{corner.y, window_.y / size_.y, size_.y, pads};
  return with_samples_like(view, resampled_light(view, across, down, pool_));
}

void ViewFitter::fit(LightField& field) {
  LightField made{{}, field.grid, {0, 0}, field.aspect, field.tiles, field.bits, {}, field.cameras, field.positions};
  for (int view = 0; view < field.grid.count(); ++view) {
    const Picture picture = fitted(view_of(field, view), field.aspect, view, field.grid);
    if (view == 0) made.view_size = size_of(picture), made.stack = blank(picture, stack_size(made));
    set_view(made, view, picture);
  }
  field = std::move(made);
}

std::string ViewFitter::description() const {
  std::string text;
  const Vec2i used(glm::round(window_));
  if (used != original_)
    text = fmt::format("{} from {}x{} to {}x{}", fit_ == AspectFit::kPad ? "padded" : "cropped", original_.x, original_.y,
                       used.x, used.y);
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : ", ") + more; };
  if (view_shift_px_ != 0.0) add(fmt::format("shifted by {:.4g} pixels from view to view", view_shift_px_));
  if (size_ != used) add(fmt::format("resized to {}x{}", size_.x, size_.y));
  return text;
}

std::string ViewFitter::coarseness() const {
  // A lens shows one sample of each view. Below half a pixel per lens, one pixel of the view spans more than two lenses.
  constexpr double kLeastPixelsPerLens = 0.5;
  if (!(window_.x < kLeastPixelsPerLens * lenses_)) return {};
  return fmt::format("the views have {:.0f} pixels across for {:.0f} lenses", window_.x, lenses_);
}

}  // namespace lippmann
