// Test prints of labelled blocks, which find the pitch or the phase of a lenticular sheet laid on them.
//
// All blocks consist of bars along the lenses.
//   pitch test   Bars are black in the left half of each strip and white in the right half. The pitch differs from block to
//                block. Through the sheet, the block with the right pitch has one shade from edge to edge. Others show
//                fringes, one per lens of difference over their width.
//   phase test   Bars are white in the middle third of each strip. The start of the strips moves to the right from block to
//                block by a share of the pitch. From the middle of the viewing zone, the block with the right phase is white.
// Blocks are arranged along the lenses: one below the other for vertical bars, side by side for horizontal ones. With an odd
// number of blocks the middle one has the nominal pitch and a star.
#pragma once

#include <string>
#include <vector>

#include "image/draw.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

enum class BarDirection { kVertical, kHorizontal };

/// The difference of the pitch from one block to the next.
struct PitchStep {
  double size = 0.1;
  enum class Unit { kPixels, kLensesPerInch } unit = Unit::kPixels;
};

/// Parses "0.1px" or "0.05lpi". Throws a usage Error naming `step`.
PitchStep read_pitch_step(const std::string& text);

struct TestBlock {
  double pitch_px = 0.0;
  double phase_px = 0.0;  ///< distance from the edge of the image to the start of a strip, across the bars
  bool is_nominal = false;
  PixelBox bars = {};
};

struct BlockTest {
  Picture picture;
  std::vector<TestBlock> blocks;
};

/// Returns a pitch test. sheet: a sheet with the nominal pitch and the size of the image. In each block, strips begin at the
/// block's edge. Throws a usage Error naming `step` if a block would have fewer than 2 pixels per lens or be narrower than a
/// lens, and naming `blocks` if the blocks do not fit on the paper. The result does not depend on the number of threads.
BlockTest pitch_test(const Display& sheet, int blocks, const PitchStep& step, BarDirection bars, const ThreadPool& pool);

/// Returns a phase test. Throws as pitch_test() does, but errors of the pitch name `lpi`.
BlockTest phase_test(const Display& sheet, int blocks, BarDirection bars, const ThreadPool& pool);

}  // namespace lippmann
