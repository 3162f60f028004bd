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
      command.add_group("Crosstalk", "For pictures beside their report.json, or native frames of --display; OUT is a folder");
  group.add_flag("--precompensate", flags.precompensate,
                 "Make pictures that crosstalk turns into those of IN, as far as values between black and white allow");
  group
      .add_option(
          "--crosstalk", flags.crosstalk,
          "With --precompensate: sigma of a Gaussian in pixels (quilts: in views), or the share of each neighbour, such as 0.4 "
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
    throw usage_error("--precompensate", "the crosstalk of the display is unknown",
                      "--crosstalk, or a --display file that states it");
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
  return fmt::format("{:.2f} % of samples are clipped at black or white; the largest remaining error is {:.2f} % of white",
                     100.0 * clipped_share, 100.0 * largest_residual);
}

}  // namespace lippmann::app
