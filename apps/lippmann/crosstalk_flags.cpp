#include "apps/lippmann/crosstalk_flags.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "replay/precompensated_frames.hpp"

namespace lippmann::app {

void add_crosstalk_flags(const Command& command, CrosstalkFlags& flags) {
  const Command group =
      command.add_group("Crosstalk", "Of pictures beside their report.json, or of native frames of --display; OUT is a folder");
  group.add_flag(
      "--precompensate", flags.precompensate,
      "Pictures that crosstalk turns into those of IN, as far as light can be neither negative nor brighter than white");
  group
      .add_option(
          "--crosstalk", flags.crosstalk,
          "Of --precompensate: a Gaussian of this sigma in pixels (quilts: views), or this share of each neighbour: 0.4 "
          "or 10%; default: the display's")
      .type_name("PIXELS|C%");
}

int run_precompensate(const CrosstalkFlags& flags, const std::string& display, const std::string& in, const std::string& out,
                      const ResultFlags& result, const Context& context) {
  PrecompensateParams params{in, out};
  std::optional<double> sigma_px;
  if (!display.empty()) {
    const Display shown_on = load_display(display);
    params.optics = native_optics(shown_on);
    sigma_px = shown_on.crosstalk_px;
  }
  if (!flags.crosstalk.empty()) sigma_px = read_crosstalk(flags.crosstalk, "--crosstalk");
  if (!sigma_px)
    throw usage_error("--precompensate", "the crosstalk of the display is not known",
                      "--crosstalk, or a --display file with it");
  params.sigma_px = *sigma_px;
  const Precompensated made = precompensate_frames(params, context);
  const Precompensation& bound = made.bound;
  if (result.json) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& path : made.written) files.push_back(path.string());
    const nlohmann::ordered_json object{
        {"clipped_share", bound.clipped_share}, {"largest_residual", bound.largest_residual}, {"files", files}};
    print_json(object);
  } else if (result.wants_text() && !made.written.empty()) {
    fmt::print("{} ... {}: {}\n", printable_line(made.written.front().string()), printable_line(made.written.back().string()),
               describe_bound(bound.clipped_share, bound.largest_residual));
  }
  return 0;
}

std::string describe_bound(double clipped_share, double largest_residual) {
  return fmt::format(
      "{:.2f} % of samples would be darker than black or brighter than white, the worst is seen {:.2f} % of "
      "white off",
      100.0 * clipped_share, 100.0 * largest_residual);
}

}  // namespace lippmann::app
