// Test prints of labelled blocks, which a lenticular sheet is laid on to find its pitch or its phase.
//
// All blocks are made of bars that run along the lenses.
//   pitch test   Bars are black in the left half of each strip, white in the right one. The pitch differs from block to block.
//                Through the sheet a block of the right pitch has one shade from edge to edge; others show fringes, one for
//                each lens by which they differ over their width.
//   phase test   Bars are white in the middle third of each strip. Strips begin at another place in each block, a share of the
//                pitch further right. From the middle of the viewing zone the block of the right phase is white.
// Blocks lie side by side along the lenses: one below the other with vertical bars, one beside the other with horizontal ones.
// The middle block of an odd number of blocks has the nominal pitch, and a star.
#pragma once

#include <string>
#include <vector>

#include "image/draw.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"

namespace lippmann {

enum class BarDirection { kVertical, kHorizontal };

/// By how much the pitch of a block differs from that of the one before.
struct PitchStep {
  double size = 0.1;
  enum class Unit { kPixels, kLensesPerInch } unit = Unit::kPixels;
};

/// "0.1px" or "0.05lpi". Throws a usage Error naming `step`.
PitchStep read_pitch_step(const std::string& text);

struct TestBlock {
  double pitch_px = 0.0;
  double phase_px = 0.0;  ///< where a strip begins, from the edge of the picture across the bars
  bool is_nominal = false;
  PixelBox bars = {};
};

struct BlockTest {
  Picture picture;
  std::vector<TestBlock> blocks;
};

/// `sheet`: of the nominal pitch; its size is that of the picture. Strips of each block begin at its edge. Throws a usage Error
/// naming `step` if a block would have fewer than 2 pixels below a lens or be narrower than one, and `blocks` if they do not
/// fit on the paper. The result is the same for any number of threads.
BlockTest pitch_test(const Display& sheet, int blocks, const PitchStep& step, BarDirection bars, const ThreadPool& pool);

/// The same, naming `lpi` for the pitch.
BlockTest phase_test(const Display& sheet, int blocks, BarDirection bars, const ThreadPool& pool);

}  // namespace lippmann
