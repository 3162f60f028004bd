// Flags that describe a lenticular sheet on a print, instead of a display file: --lpi 60.12 --dpi 600 --paper A5.
#pragma once

#include <string>

namespace lippmann::app {

class Command;

struct SheetFlags {
  std::string lpi, lenses_per_mm, pitch_mm, visual_lpi, dpi, paper, phase;
  bool landscape = false;

  /// Values of other flags of the command that also describe the sheet; empty: not given.
  struct Others {
    std::string display, viewing_distance_mm, view_angle_deg;
  };

  /// Returns the name of the first flag that is given, or an empty string.
  std::string first_given() const;
  /// Returns whether --view-angle affects the pitch of the print. It does not if --visual-lpi states a measured pitch.
  bool pitch_depends_on_angle(bool has_viewing_distance) const {
    return are_given() && visual_lpi.empty() && has_viewing_distance;
  }
  bool are_given() const { return !first_given().empty(); }
  /// Returns the display as one line of text for load_display(). Throws a usage Error if --display is given too, or if a
  /// required flag is missing.
  std::string line(const Others& others) const;
};

void add_sheet_flags(const Command& command, SheetFlags& flags);

}  // namespace lippmann::app
