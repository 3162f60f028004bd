// `lippmann plan SCENE --units N`: divides a job into N parts (units), and estimates their cost.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/param_flags.hpp"
#include "apps/lippmann/print_json.hpp"
#include "core/frame_ranges.hpp"
#include "distribute/units.hpp"
#include "job/size_estimate.hpp"
#include "job/unit_plan.hpp"

namespace lippmann::app {
namespace {

struct PlanOptions {
  ParamFlags flags;
  int units = 1;
  bool only_list = false, json = false;
};

std::string seconds_text(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.{}f} s", seconds, seconds < 10.0 ? 1 : 0);
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string most_units_text(const UnitPlan& plan) {
  if (plan.units.size() > 1) return fmt::format("The job can be cut into at most {} units.", plan.units.size());
  if (plan.units.front().frames.size() == 1)
    return "A job of one frame is one unit unless it is rendered in strips (--strips).";
  return "All frames must be rendered together, so the job is one unit.";
}

/// Describes what one unit of a job renders, as "frames 0-3" or "strips 0-1 of frame 0, 0-7 of frame 1".
std::string parts_text(const PlannedUnit& unit) {
  if (unit.strips.empty()) return "frames " + write_frames(ranges_of(unit.frames));
  std::string text;
  for (const auto& [frame, strips] : unit.strips)
    text += fmt::format("{} {} of frame {}", text.empty() ? "strips" : ",", write_frames(ranges_of(strips)), frame);
  return text;
}

void print_text(const PlanOptions& options, const UnitPlan& plan) {
  const int count = static_cast<int>(plan.units.size());
  for (int i = 0; i < count; ++i) {
    const PlannedUnit& unit = plan.units[static_cast<std::size_t>(i)];
    fmt::print("{:>9}  {}{}\n", write_units({{i + 1}, count}), parts_text(unit),
               unit.cpu_seconds ? fmt::format(", about {} of CPU time", seconds_text(*unit.cpu_seconds)) : "");
  }
  if (plan.segment > 1)
    fmt::print("Units begin at multiples of {} frames, because that many frames are rendered together.\n", plan.segment);
  if (count < options.units) fmt::print("{}\n", most_units_text(plan));
  if (!plan.costs) return;
  double all = 0.0;
  for (const PlannedUnit& unit : plan.units) all += *unit.cpu_seconds;
  fmt::print("About {} of CPU time in all and {} of memory each, measured on this machine with {}frames {}.\n",
             seconds_text(all), bytes_text(static_cast<double>(plan.costs->peak_memory_bytes)),
             plan.units.front().strips.empty() ? "" : "strips of ", write_frames(ranges_of(plan.costs->frames)));
  if (plan.join_bytes)
    fmt::print("'lippmann finish', which joins the strips, takes about {} of memory.\n", bytes_text(*plan.join_bytes));
}

nlohmann::ordered_json plan_json(const UnitPlan& plan) {
  nlohmann::ordered_json units = nlohmann::ordered_json::array();
  const int count = static_cast<int>(plan.units.size());
  for (int i = 0; i < count; ++i) {
    const PlannedUnit& unit = plan.units[static_cast<std::size_t>(i)];
    units.push_back({{"unit", write_units({{i + 1}, count})}, {"frames", write_frames(ranges_of(unit.frames))}});
    for (const auto& [frame, strips] : unit.strips)
      units.back()["strips"][std::to_string(frame)] = write_frames(ranges_of(strips));
    units.back()["cpu_seconds"] = unit.cpu_seconds ? nlohmann::ordered_json(*unit.cpu_seconds) : nullptr;
  }
  nlohmann::ordered_json json{{"segment", plan.segment}, {"units", std::move(units)}};
  json["measured_frames"] = plan.costs ? write_frames(ranges_of(plan.costs->frames)) : "";
  json["peak_memory_bytes"] = plan.costs ? nlohmann::ordered_json(plan.costs->peak_memory_bytes) : nullptr;
  if (plan.join_bytes) json["finish_memory_bytes"] = static_cast<std::uint64_t>(*plan.join_bytes);
  return json;
}

int run(const PlanOptions& options, const Context& context) {
  const UnitPlan plan = plan_units(options.flags.resolve(), options.units, !options.only_list, context);
  if (context.cancelled) return 1;
  if (options.json)
    print_json(plan_json(plan));
  else
    print_text(options, plan);
  return 0;
}

}  // namespace

void add_plan_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<PlanOptions>();
  const Command command = root.add_command("plan", "Cut a job into units that different machines render, and estimate them");
  add_param_flags(command, options->flags);
  command.add_option("--units", options->units, "Number of units to cut the job into; a job of fewer parts has fewer")
      .required()
      .type_name("N")
      .range(1, 1'000'000)
      .group("Plan");
  command.add_flag("--only-list", options->only_list, "Measure no frames: list the units without estimates").group("Plan");
  command.add_flag("--json", options->json, "Print the plan as JSON").group("Plan");
  command.short_help({"--units", "--only-list", "--json", "--frames", "--spp", "--size"},
                     "Examples:\n"
                     "  lippmann plan film.toml --units 8                   frames, CPU time and memory of 8 units\n"
                     "  lippmann render film.toml -o film --unit 1/8        the first of them, into the common folder\n"
                     "  lippmann finish film                                when all have been rendered\n");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
