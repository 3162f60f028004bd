#include "layout/print_finish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "image/draw.hpp"
#include "image/limits.hpp"
#include "layout/picture_samples.hpp"
#include "layout/strip_place.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr double kMarginMm = 10.0;

int bleed_px(const Display& display, double bleed_mm) { return static_cast<int>(std::lround(bleed_mm / display.pixel_mm())); }

/// Copies a box to a position in a picture with the same sample type.
void copy_box(const Picture& from, const PixelBox& box, Picture& to, Vec2i corner) {
  const Vec2i from_size = size_of(from), to_size = size_of(to);
  std::visit(
      [&](const auto& source) {
        auto& target = samples_of(std::get<std::remove_cvref_t<decltype(source)>>(to));
        for (int y = 0; y < box.size().y; ++y) {
          const auto first = static_cast<std::ptrdiff_t>(box.from.y + y) * from_size.x + box.from.x;
          const auto place = static_cast<std::ptrdiff_t>(corner.y + y) * to_size.x + corner.x;
          std::copy_n(samples_of(source).begin() + 3 * first, 3 * box.size().x, target.begin() + 3 * place);
        }
      },
      from);
}

/// The square inch in the middle of a box, or a smaller box if `box` is smaller.
PixelBox middle_inch(const PixelBox& box, double dpi) {
  const Vec2i size = glm::min(box.size(), Vec2i(static_cast<int>(std::lround(dpi))));
  const Vec2i from = box.from + (box.size() - size) / 2;
  return {from, from + size};
}

PixelBox grown(const PixelBox& box, int by) { return {box.from - by, box.to + by}; }

/// Draws the marks of a print, whose cut edges are `trim`, into a picture with white margins.
class PrintMarks {
 public:
  /// `origin`: position of the first pixel of `picture` in the display's picture; negative in a margin. `picture` and `display`
  /// must outlive this object.
  PrintMarks(Picture& picture, const PixelBox& trim, const PixelBox& bleed, const Display& display, Vec2i origin)
      : picture_(picture), trim_(trim), bleed_(bleed), display_(display), origin_(origin) {}

  void draw() {
    for (const int x : {trim_.from.x, trim_.to.x}) {
      line({x, bleed_.from.y - px(8.0)}, {x, bleed_.from.y - px(2.0)});
      line({x, bleed_.to.y + px(2.0)}, {x, bleed_.to.y + px(8.0)});
    }
    for (const int y : {trim_.from.y, trim_.to.y}) {
      line({bleed_.from.x - px(8.0), y}, {bleed_.from.x - px(2.0), y});
      line({bleed_.to.x + px(2.0), y}, {bleed_.to.x + px(8.0), y});
    }
    const Vec2i middle = (trim_.from + trim_.to) / 2;
    target({middle.x, bleed_.from.y - px(6.0)});
    target({middle.x, bleed_.to.y + px(6.0)});
    target({bleed_.from.x - px(6.0), middle.y});
    target({bleed_.to.x + px(6.0), middle.y});
    if (display_.kind == DisplayKind::kLenticularSheet) {
      const int first = trim_.from.x + px(2.0), end = trim_.to.x - px(2.0);
      band({{first, bleed_.from.y - px(3.0)}, {end, bleed_.from.y - px(1.0)}});
      band({{first, bleed_.to.y + px(1.0)}, {end, bleed_.to.y + px(3.0)}});
    }
    legend(middle.x);
  }

 private:
  int px(double mm) const { return static_cast<int>(std::lround(mm / display_.pixel_mm())); }
  int thickness() const { return std::max(1, px(0.1)); }

  /// Draws a horizontal or vertical line. `from` and `to` are in the middle of the line's thickness.
  void line(Vec2i from, Vec2i to) {
    const int before = thickness() / 2, after = thickness() - before;
    const Vec2i across(from.x == to.x ? 1 : 0, from.y == to.y ? 1 : 0);
    fill_box(picture_, {from - before * across, to + after * across}, kBlackRgb);
  }

  void target(Vec2i centre) {
    const int arm = px(2.5);
    line({centre.x - arm, centre.y}, {centre.x + arm, centre.y});
    line({centre.x, centre.y - arm}, {centre.x, centre.y + arm});
    const double radius = 1.5 / display_.pixel_mm(), half = 0.5 * thickness();
    for (int y = -arm; y <= arm; ++y)
      for (int x = -arm; x <= arm; ++x)
        if (std::abs(std::sqrt(static_cast<double>(x * x + y * y)) - radius) < half)
          fill_box(picture_, {centre + Vec2i(x, y), centre + Vec2i(x + 1, y + 1)}, kBlackRgb);
  }

  void band(const PixelBox& box) {
    const LensStrips strips = lens_strips(display_);
    for (int y = box.from.y; y < box.to.y; ++y)
      for (int x = box.from.x; x < box.to.x; ++x) {
        const double within = strip_place(strips, Vec2d(origin_ + Vec2i(x, y)) + 0.5).within;
        if (std::abs(within - 0.5) < 1.0 / 6.0) fill_box(picture_, {{x, y}, {x + 1, y + 1}}, kBlackRgb);
      }
  }

  /// Writes the resolution and the lens pitch below the left half of the print.
  void legend(int middle) {
    std::string text = fmt::format("{:g} dpi", display_.dpi);
    if (display_.kind == DisplayKind::kLenticularSheet)
      text = fmt::format("{:.5g} lpi\n{}", display_.dpi / lens_strips(display_).cell_px, text);
    const int left = trim_.from.x + px(2.0);
    const Vec2i room(middle - px(3.0) - left, px(5.0)), units = text_units(text);
    const int scale = std::min(room.x / units.x, room.y / units.y);
    if (scale > 0) draw_text(picture_, {left, bleed_.to.y + px(4.5)}, scale, text);
  }

  Picture& picture_;
  PixelBox trim_, bleed_;
  const Display& display_;
  Vec2i origin_;
};

}  // namespace

Display with_bleed(const Display& display, double bleed_mm) {
  const int bleed = bleed_px(display, bleed_mm);
  if (bleed == 0) return display;
  Display bled = display;
  bled.viewing_distance_mm = viewing_distance_mm(display);  // the default depends on the display's height, which grows
  bled.pixels += 2 * bleed;
  const LensStrips strips = lens_strips(display);
  if (bled.lenses.phase_px) *bled.lenses.phase_px += bleed * (1.0 - strips.sine / strips.cosine);
  return bled;
}

Picture finished(Picture bled, const Display& display, const PrintFinish& finish) {
  const int bleed = bleed_px(display, finish.bleed_mm);
  const Vec2i size = size_of(bled);
  PixelBox trim = grown({Vec2i(0), size}, -bleed);
  if (finish.proof) {
    const PixelBox inch = middle_inch(trim, display.dpi);
    if (inch.size() == trim.size())
      throw usage_error("proof",
                        fmt::format("the print of {}x{} pixels is not larger than an inch", inch.size().x, inch.size().y),
                        "a larger print");
    trim = inch;
  }
  const PixelBox kept = grown(trim, bleed);
  const int margin = finish.marks ? static_cast<int>(std::lround(kMarginMm / display.pixel_mm())) : 0;
  if (kept.size() == size && margin == 0) return bled;
  const Vec2i whole = kept.size() + 2 * margin;
  check_image_size("marks", whole.x, whole.y, 3);
  Picture print = blank(bled, whole);
  if (margin > 0) fill_box(print, {Vec2i(0), whole}, kWhiteRgb);
  copy_box(bled, kept, print, Vec2i(margin));
  const Vec2i origin = kept.from - margin;
  if (finish.marks)
    PrintMarks(print, {trim.from - origin, trim.to - origin}, {kept.from - origin, kept.to - origin}, display, origin).draw();
  return print;
}

}  // namespace lippmann
