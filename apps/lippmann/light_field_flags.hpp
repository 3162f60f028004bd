// Flags that describe a light field without a report.json.
#pragma once

#include <optional>
#include <string>

#include "apps/lippmann/sheet_flags.hpp"
#include "lippmann/replay/light_field_frames.hpp"

namespace lippmann::app {

class Command;

struct LightFieldFlags {
  std::string report, from, views, quilt, display;
  std::optional<double> view_angle_deg;
  bool cone_ends = false;
  SheetFlags sheet;  ///< describes the display, instead of --display

  /// Returns the display that --display or the sheet flags describe, or an empty string. Throws a usage Error if both are
  /// given.
  std::string named_display() const;
  /// Throws a usage Error naming an invalid flag.
  LightFieldHints read() const;
};

/// Declares all flags except --report, --display and the sheet flags.
void add_light_field_flags(const Command& command, LightFieldFlags& flags);

/// Declares --report, --display and the sheet flags. more: text at the end of the help of --display.
void add_report_flags(const Command& command, LightFieldFlags& flags, const std::string& more);

}  // namespace lippmann::app
