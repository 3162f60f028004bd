// Makes test prints of labelled blocks. A lenticular sheet on the print shows which block has the pitch or phase of the sheet.
//
// Blocks consist of bars parallel to the lenses, one bar in each strip (the part of the print below a lens).
//   pitch test   Strips are half black, half white. Each block has another strip width. Seen through the sheet, the block with
//                the right pitch has a uniform shade, and other blocks show fringes.
//   phase test   Strips are white in the middle third. Each block shifts them by a fraction of the pitch. Seen from the middle
//                of the viewing zone, the block with the right phase is white.
// If the number of blocks is odd, the middle block has the nominal pitch and its label has a star.
#pragma once

#include <string>
#include <vector>

#include "image/draw.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

enum class BarDirection { kVertical, kHorizontal };

/// Difference of the pitch from one block to the next.
struct PitchStep {
  double size = 0.1;
  enum class Unit { kPixels, kLensesPerInch } unit = Unit::kPixels;
};

/// Parses "0.1px" or "0.05lpi". Throws a usage Error naming `step`.
PitchStep read_pitch_step(const std::string& text);

struct TestBlock {
  double pitch_px = 0.0;
  double phase_px = 0.0;  ///< distance of a strip's edge from the image's edge, perpendicular to the bars
  bool is_nominal = false;
  PixelBox bars = {};
};

struct BlockTest {
  Picture picture;
  std::vector<TestBlock> blocks;
};

/// Returns a pitch test. `sheet` states the nominal pitch and the size of the image. Throws a usage Error that names `step` if
/// a block would have fewer than 2 pixels per lens or be narrower than a lens, or `blocks` if the blocks do not fit on the
/// paper. The result does not depend on the number of threads.
BlockTest pitch_test(const Display& sheet, int blocks, const PitchStep& step, BarDirection bars, const ThreadPool& pool);

/// Returns a phase test. Throws as pitch_test() does, but names `lpi` in errors about the pitch.
BlockTest phase_test(const Display& sheet, int blocks, BarDirection bars, const ThreadPool& pool);

}  // namespace lippmann
