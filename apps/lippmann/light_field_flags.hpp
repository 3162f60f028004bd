// Flags that say what a light field is where no report.json describes it.
#pragma once

#include <optional>
#include <string>

#include "lippmann/replay/light_field_frames.hpp"

namespace lippmann::app {

class Command;  // command_line.hpp

struct LightFieldFlags {
  std::string report, from, views, quilt, display;
  std::optional<double> view_angle_deg;
  bool cone_ends = false;

  /// Throws a usage Error naming the flag.
  LightFieldHints read() const;
};

/// All but --report and --display, in a group of their own.
void add_light_field_flags(const Command& command, LightFieldFlags& flags);

/// --report and --display. `more` ends the help of the latter.
void add_report_flags(const Command& command, LightFieldFlags& flags, const std::string& more);

}  // namespace lippmann::app
