#include "sheet/test_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "image/limits.hpp"
#include "layout/strip_place.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {
namespace {

constexpr double kMarginMm = 3.0, kGapMm = 1.0, kCapitalMm = 2.0;
constexpr double kHalfBar = 0.5, kThirdBar = 1.0 / 3.0;

/// Layout of a test print, in pixels from the edge of the image. "Across" is perpendicular to the bars, and "along" is parallel
/// to them.
struct BlockLayout {
  bool is_vertical = true;
  int scale = 1;                         ///< pixels per unit of the font
  Vec2i header{0, 0};                    ///< corner of the heading above all blocks
  int first_across = 0, end_across = 0;  ///< start and end of every block across the bars
  /// Start of the first block, distance between the starts of blocks, and gap between blocks.
  int first_along = 0, pitch = 0, gap = 0;
  int label_across = 0;  ///< start of the labels across the bars

  PixelBox block(int number) const {
    const int from = first_along + number * pitch, to = from + pitch - gap;
    return is_vertical ? PixelBox{{first_across, from}, {end_across, to}} : PixelBox{{from, first_across}, {to, end_across}};
  }
  Vec2i label(int number, Vec2i units) const {
    const PixelBox box = block(number);
    if (is_vertical) return {label_across, box.from.y + std::max(0, (box.size().y - scale * units.y) / 2)};
    return {box.from.x, label_across};
  }
};

Vec2i largest_units(const std::vector<std::string>& labels) {
  Vec2i largest(1);
  for (const std::string& label : labels) largest = glm::max(largest, text_units(label));
  return largest;
}

/// Text is 2 mm high, or smaller if a label would not fit beside its block or would take more than a third of the image.
BlockLayout block_layout(const Display& sheet, const std::string& header, const std::vector<std::string>& labels,
                         BarDirection bars) {
  const auto px = [&](double mm) { return static_cast<int>(std::lround(mm / sheet.pixel_mm())); };
  const int count = static_cast<int>(labels.size());
  const Vec2i size = sheet.pixels, units = largest_units(labels) + Vec2i(2, 0);
  BlockLayout layout;
  layout.is_vertical = bars == BarDirection::kVertical;
  const int margin = std::min(px(kMarginMm), std::min(size.x, size.y) / 20);
  const int wish = std::max(1, px(kCapitalMm) / kTextCapital);
  const int room_along = (layout.is_vertical ? size.y : size.x) - 2 * margin,
            room_across = layout.is_vertical ? size.x : size.y;
  const int unit_along = layout.is_vertical ? units.y : units.x,
            unit_across = layout.is_vertical ? units.x : units.y + kTextLine;
  const int header_lines = layout.is_vertical ? 1 : 0;
  // The largest text size up to `wish` at which blocks, labels and header fit. A label takes at most a third of the width
  // across the bars.
  const int by_along = (room_along - count) / (count * unit_along + header_lines * kTextLine);
  layout.scale = std::min({wish, by_along, room_across / 3 / unit_across, (size.x - 2 * margin) / text_units(header).x});
  if (layout.scale < 1)
    throw usage_error("blocks", fmt::format("{} labelled blocks do not fit on {}x{} pixels", count, size.x, size.y),
                      "fewer blocks, or a larger print");
  layout.header = {margin, margin};
  layout.label_across = margin + (layout.is_vertical ? 0 : kTextLine * layout.scale);
  layout.first_across = margin + unit_across * layout.scale;
  layout.end_across = room_across - margin;
  layout.first_along = margin + header_lines * kTextLine * layout.scale;
  layout.pitch = (room_along - header_lines * kTextLine * layout.scale) / count;
  layout.gap = std::clamp(px(kGapMm), 1, std::max(1, layout.pitch - unit_along * layout.scale));
  return layout;
}

/// The part of each strip that a bar fills, as fractions of the strip's width.
struct Bars {
  double from = 0.0, to = kHalfBar;
  bool is_black_inside = true;
};

void draw_bars(Picture& picture, const TestBlock& block, const LensStrips& sheet, const Bars& bars, BarDirection direction,
               const ThreadPool& pool) {
  LensStrips strips = sheet;
  strips.cell_px = block.pitch_px, strips.start_px = block.phase_px;
  auto& image = std::get<Image8>(picture);
  pool.for_each(static_cast<std::size_t>(block.bars.size().y), [&](std::size_t row) {
    const int y = block.bars.from.y + static_cast<int>(row);
    for (int x = block.bars.from.x; x < block.bars.to.x; ++x) {
      const Vec2d centre(x + 0.5, y + 0.5);
      const bool is_vertical = direction == BarDirection::kVertical;
      const double within = strip_place(strips, is_vertical ? centre : Vec2d(centre.y, centre.x)).within;
      const bool is_black = (within >= bars.from && within < bars.to) == bars.is_black_inside;
      if (is_black) std::fill_n(image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + x), 3, 0);
    }
  });
}

struct PlannedBlock {
  TestBlock block;
  std::string label;
};

struct TestPlan {
  std::string header;
  std::vector<PlannedBlock> blocks;
  Bars bars;
  bool starts_at_block = false;  ///< whether strips begin at the edge of the block instead of the edge of the image
};

BlockTest drawn(const TestPlan& plan, const Display& sheet, BarDirection bars, const ThreadPool& pool) {
  check_image_size("paper", sheet.pixels.x, sheet.pixels.y, 3);
  std::vector<std::string> labels;
  for (const PlannedBlock& planned : plan.blocks) labels.push_back(planned.label);
  const BlockLayout layout = block_layout(sheet, plan.header, labels, bars);
  BlockTest test;
  test.picture = blank(Image8{}, sheet.pixels);
  fill_box(test.picture, {Vec2i(0), sheet.pixels}, kWhiteRgb);
  draw_text(test.picture, layout.header, layout.scale, plan.header);
  const LensStrips strips = lens_strips(sheet);
  for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
    const auto& [planned, label] = plan.blocks[static_cast<std::size_t>(i)];
    TestBlock block = planned;
    block.bars = layout.block(i);
    if (plan.starts_at_block) block.phase_px = layout.first_across;
    draw_text(test.picture, layout.label(i, text_units(label)), layout.scale, label);
    draw_bars(test.picture, block, strips, plan.bars, bars, pool);
    test.blocks.push_back(block);
  }
  return test;
}

int room_across(const Display& sheet, BarDirection bars) {
  return bars == BarDirection::kVertical ? sheet.pixels.x : sheet.pixels.y;
}

/// Labels have one line beside vertical bars and two lines above horizontal bars.
const char* separator(BarDirection bars) { return bars == BarDirection::kVertical ? "  " : "\n"; }

std::string header_of(const char* name, const Display& sheet) {
  return fmt::format("{}  {:g} dpi  print at 100 %", name, sheet.dpi);
}

double stepped(double nominal_px, double dpi, double steps, const PitchStep& step) {
  if (step.unit == PitchStep::Unit::kPixels) return nominal_px + steps * step.size;
  const double lpi = dpi / nominal_px + steps * step.size;
  return lpi > 0.0 ? dpi / lpi : 0.0;
}

}  // namespace

PitchStep read_pitch_step(const std::string& text) {
  const auto number_before = [&](std::string_view unit) {
    return read_number(text.substr(0, text.size() - unit.size()), 1e-6, 1e3, "step");
  };
  if (text.ends_with("px")) return {number_before("px"), PitchStep::Unit::kPixels};
  if (text.ends_with("lpi")) return {number_before("lpi"), PitchStep::Unit::kLensesPerInch};
  throw usage_error("step", shown(text) + " has no unit", "0.1px or 0.05lpi");
}

BlockTest pitch_test(const Display& sheet, int blocks, const PitchStep& step, BarDirection bars, const ThreadPool& pool) {
  TestPlan plan;
  plan.header = header_of("Pitch test", sheet);
  plan.starts_at_block = true;
  const double nominal = lens_strips(sheet).cell_px;
  for (int i = 0; i < blocks; ++i) {
    const double steps = i - 0.5 * (blocks - 1);
    TestBlock block;
    block.pitch_px = stepped(nominal, sheet.dpi, steps, step), block.is_nominal = steps == 0.0;
    constexpr double kRoundingPx = 1e-6;
    if (block.pitch_px < 2.0 - kRoundingPx || block.pitch_px > room_across(sheet, bars))
      throw usage_error("step",
                        fmt::format("gives block {} of {} a pitch of {:.5g} pixels (the pitch of the sheet is {:.5g})", i + 1,
                                    blocks, block.pitch_px, nominal),
                        "a step with which the pitches of all blocks are from 2 pixels to the width of the print");
    plan.blocks.push_back({block, fmt::format("{:.3f} lpi{}{:.3f} px{}", sheet.dpi / block.pitch_px, separator(bars),
                                              block.pitch_px, block.is_nominal ? " *" : "")});
  }
  return drawn(plan, sheet, bars, pool);
}

BlockTest phase_test(const Display& sheet, int blocks, BarDirection bars, const ThreadPool& pool) {
  TestPlan plan;
  const double pitch = lens_strips(sheet).cell_px;
  if (pitch > room_across(sheet, bars))
    throw usage_error("lpi",
                      fmt::format("makes lenses {:.5g} pixels wide on a print of {} pixels", pitch, room_across(sheet, bars)),
                      "lenses narrower than the print");
  plan.header = header_of(fmt::format("Phase test  {:.5g} lpi", sheet.dpi / pitch).c_str(), sheet);
  plan.bars = {kThirdBar, 1.0 - kThirdBar, false};
  for (int i = 0; i < blocks; ++i) {
    TestBlock block;
    block.pitch_px = pitch, block.phase_px = pitch * i / blocks;
    plan.blocks.push_back({block, fmt::format("phase{}{:.3f} px", separator(bars), block.phase_px)});
  }
  return drawn(plan, sheet, bars, pool);
}

}  // namespace lippmann
