#include "apps/lippmann/light_field_flags.hpp"

#include <fmt/core.h>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/grid_flag.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann::app {

std::string LightFieldFlags::named_display() const {
  if (!sheet.are_given()) return display;
  return sheet.line({display, "", view_angle_deg ? fmt::format("{}", *view_angle_deg) : ""});
}

LightFieldHints LightFieldFlags::read() const {
  LightFieldHints hints{report, from, read_grid(views, "--views"), read_grid(quilt, "--quilt"), view_angle_deg, cone_ends};
  if (const std::string name = named_display(); !name.empty()) hints.display = load_display(name);
  return hints;
}

void add_report_flags(const Command& command, LightFieldFlags& flags, const std::string& more) {
  command.add_option("--report", flags.report, "Path of report.json, if it is not beside the pictures").type_name("FILE");
  command
      .add_option("--display", flags.display,
                  "The display of IN, which is a native frame, a quilt or a row of views: a name (see: lippmann displays), a "
                  "calibration .json, or a .toml of your own" +
                      more)
      .type_name("NAME|FILE");
  add_sheet_flags(command, flags.sheet);
}

void add_light_field_flags(const Command& command, LightFieldFlags& flags) {
  const Command group = command.add_group("Light fields without a report.json");
  group.add_option("--from", flags.from, "Format of IN, from the list in `lippmann convert --help`; default: from its name")
      .type_name("FORMAT");
  group.add_option("--views", flags.views, "Number of views across and up").type_name("CxR");
  group.add_option("--quilt", flags.quilt, "Number of tiles of a quilt").type_name("CxR");
  group
      .add_option("--view-angle", flags.view_angle_deg,
                  "Angle over which the views spread; default: the angle of --display, else 40 for a row of views, 10 for a "
                  "grid of cameras")
      .type_name("DEG")
      .range(0.001, 179.0);
  group.add_flag("--cone-ends", flags.cone_ends,
                 "The outermost views of a row lie at the ends of that angle; default: half a step inside");
}

}  // namespace lippmann::app
