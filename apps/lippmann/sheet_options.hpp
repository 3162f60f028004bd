// The flags of `lippmann sheet`, and the kinds of sheets on which each flag has an effect.
#pragma once

#include <optional>
#include <string>

#include "apps/lippmann/result_flags.hpp"
#include "apps/lippmann/sheet_flags.hpp"
#include "lippmann/display/display.hpp"
#include "sheet/lens_heights.hpp"
#include "sheet/test_blocks.hpp"

namespace lippmann::app {

enum class SheetKind { kPitch, kPhase, kViewingZone, kLens };

struct SheetOptions {
  std::string kind_name, out, display, step, bars, to;
  std::optional<int> blocks, views;
  std::optional<double> viewing_distance_mm, view_angle_deg, refractive_index;
  SheetFlags sheet;
  LensSpec lens;
  ResultFlags result;

  SheetKind kind() const;
  int block_count() const;
  PitchStep pitch_step() const;
  BarDirection bar_direction() const;
  LensSpec lens_spec() const;
  /// Returns the sheet. Test prints have the paper size A4 by default. Throws a usage Error naming an invalid flag.
  Display read_sheet() const;
};

void add_sheet_options(const Command& command, SheetOptions& options);

/// Throws a usage Error for a flag that has no effect on this kind of sheet.
void refuse_idle_flags(const SheetOptions& options);

}  // namespace lippmann::app
