#include "apps/lippmann/orthoscopic_flags.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "replay/orthoscopic.hpp"

namespace lippmann::app {

void add_orthoscopic_flags(const Command& command, OrthoscopicFlags& flags) {
  const Command group = command.add_group("Inverted depth", "For pictures beside their report.json; OUT is a folder");
  group.add_flag("--rotate-elemental", flags.rotate_elemental,
                 "Rotate every elemental image by 180 degrees, which turns depth z into -z");
  group
      .add_option("--spoc", flags.spoc_mm,
                  "Smart pseudoscopic-to-orthoscopic conversion: distance in front of the recording array that becomes depth 0")
      .type_name("MM");
  group
      .add_option("--reference-plane", flags.reference_mm,
                  "With --spoc: the distance that stays sharpest; default: the same distance")
      .type_name("MM");
  group.add_option("--lens-pitch", flags.lens_pitch_mm, "With --spoc: lens pitch of the display; default: as recorded")
      .type_name("MM");
  group.add_option("--gap", flags.gap_mm, "With --spoc: gap between the display's lenses and pixels; default: as recorded")
      .type_name("MM");
  group
      .add_option("--lens-pixels", flags.lens_pixels,
                  "With --spoc: pixels below each lens of the display; default: as recorded")
      .type_name("N");
}

int run_orthoscopic(const OrthoscopicFlags& flags, const std::string& in, const std::string& out, const ResultFlags& result,
                    const Context& context) {
  OrthoscopicParams params{in, out};
  if (flags.spoc_mm) params.spoc = SpocParams{*flags.spoc_mm, flags.reference_mm.value_or(*flags.spoc_mm)};
  params.lens_pitch_mm = flags.lens_pitch_mm, params.gap_mm = flags.gap_mm, params.lens_pixels = flags.lens_pixels;
  const auto written = convert_to_orthoscopic(params, context);
  if (result.json) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& path : written) files.push_back(path.string());
    print_json(nlohmann::ordered_json{{"files", files}});
  } else if (result.wants_text() && !written.empty()) {
    fmt::print("{} ... {}\n", printable_line(written.front().string()), printable_line(written.back().string()));
  }
  return 0;
}

}  // namespace lippmann::app
