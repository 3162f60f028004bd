#include "apps/lippmann/stereo_flags.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/printable.hpp"
#include "job/param_text.hpp"
#include "lippmann/core/error.hpp"
#include "replay/stereo_frames.hpp"

namespace lippmann::app {
std::optional<StereoLayout> StereoFlags::layout() const {
  if (packing.empty() && !right_first) return std::nullopt;
  StereoLayout layout;
  if (!packing.empty()) layout.packing = static_cast<StereoPacking>(read_choice(packing, kStereoPackingNames, "--stereo"));
  layout.right_first = right_first;
  return layout;
}

void add_stereo_flags(const Command& command, StereoFlags& flags) {
  const Command group =
      command.add_group("Stereo pictures", "With --to stereo; a light field of two views keeps them unchanged");
  group
      .add_option("--stereo", flags.packing,
                  "Arrangement of the two views: sbs (side by side, default), half-sbs, over-under, half-over-under or rows; "
                  "describes OUT with --to stereo, else IN")
      .type_name("PACKING");
  group.add_flag("--right-first", flags.right_first,
                 "The right eye's view comes first: at the left, on top, or in the first row");
  group.add_option("--ipd", flags.ipd_mm, "Distance between the pupils of the eyes; default: 63")
      .type_name("MM")
      .range(0.1, 1000.0);
  group
      .add_option("--viewing-distance", flags.viewing_distance_mm,
                  "Distance of the eyes from the screen; default: the distance that the light field was made for")
      .type_name("MM")
      .range(1.0, 1e6);
  group
      .add_option("--screen-width", flags.screen_width_mm,
                  "Width of the screen that the light field fills; default: the width that the light field states")
      .type_name("MM")
      .range(1.0, 1e6);
  group
      .add_option("--view-angle", flags.view_angle_deg,
                  "Angle between the outermost views if the positions of their cameras are unknown; default: 40, or 10 for a "
                  "grid of views")
      .type_name("DEG")
      .range(0.001, 179.0);
}

int run_stereo(const StereoFlags& flags, const LightFieldHints& field, const std::string& in, const std::string& out,
               const ResultFlags& result, const Context& context) {
  StereoParams params{in, out, field};
  params.layout = flags.layout().value_or(StereoLayout{});
  params.ipd_mm = flags.ipd_mm;
  params.distance_mm = flags.viewing_distance_mm, params.screen_width_mm = flags.screen_width_mm;
  const ConvertedStereo made = convert_to_stereo(params, context);
  if (result.json) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& path : made.written) files.push_back(path.string());
    print_json(nlohmann::ordered_json{{"views", {2, 1}},
                                      {"view_size", {made.view_size.x, made.view_size.y}},
                                      {"out_of_zone", made.out_of_zone},
                                      {"files", files}});
  } else if (result.wants_text() && !made.written.empty()) {
    fmt::print("2x1 views of {}x{} pixels: {}{}\n", made.view_size.x, made.view_size.y,
               printable_line(made.written.front().string()),
               made.written.size() > 1 ? " ... " + printable_line(made.written.back().string()) : "");
  }
  return 0;
}

}  // namespace lippmann::app
