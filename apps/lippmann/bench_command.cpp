// `lippmann bench NAME`: runs a benchmark of bench/ and prints its rows as a table or as JSON.
#include <fmt/ranges.h>
#include <sys/utsname.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print.hpp"
#include "apps/lippmann/print_json.hpp"
#include "bench/bench.hpp"
#include "core/cpu_model.hpp"
#include "core/json_text.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {
namespace {

struct BenchOptions {
  std::string name;
  bench::Request request;
  int threads = 0;
  bool json = false;
  std::vector<std::pair<std::string, Flag>> own;  ///< flags that only some benchmarks take
};

nlohmann::ordered_json describe_machine(const Context& context) {
  utsname system{};
  uname(&system);
  return {{"cpu", cpu_model()},
          {"threads", resolved_threads(context)},
          {"system", std::string(system.sysname) + " " + system.release},
          {"compiler", std::string("g++ ") + __VERSION__}};
}

std::string cell(const nlohmann::ordered_json& value) {
  if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : json_to_text(value, -1);
}

void print_table(const bench::Report& report) {
  if (report.rows.empty()) return;
  std::vector<std::size_t> widths;
  for (const auto& [key, ignored] : report.rows[0].items()) widths.push_back(key.size());
  for (const auto& row : report.rows) {
    std::size_t column = 0;
    for (const auto& [key, value] : row.items()) {
      if (column == widths.size()) widths.push_back(key.size());
      widths[column] = std::max(widths[column], cell(value).size());
      ++column;
    }
  }
  std::size_t column = 0;
  for (const auto& [key, ignored] : report.rows[0].items()) fmt::print("{:>{}}  ", key, widths[column++]);
  fmt::print("\n");
  for (const auto& row : report.rows) {
    column = 0;
    for (const auto& [key, value] : row.items()) fmt::print("{:>{}}  ", cell(value), widths[column++]);
    fmt::print("\n");
  }
  fmt::print("{} checks of results passed\n", report.passed_checks);
}

const bench::Benchmark& find_benchmark(const std::string& name) {
  std::vector<std::string_view> known;
  for (const bench::Benchmark& benchmark : bench::benchmarks()) {
    if (benchmark.name == name) return benchmark;
    known.push_back(benchmark.name);
  }
  throw usage_error("bench", "there is no benchmark '" + name + "'" + did_you_mean(name, known),
                    fmt::format("{}", fmt::join(known, ", ")));
}

/// Frames that were stopped half-way are wrong, and so are figures of them and complaints about them.
bench::Report run_to_the_end(const bench::Benchmark& benchmark, const bench::Request& request, const Context& context) {
  const auto stopped = [&] { return Error("bench " + std::string(benchmark.name), "was stopped before its end"); };
  try {
    bench::Report report = benchmark.run(request, context);
    if (context.cancelled) throw stopped();
    return report;
  } catch (const std::exception&) {
    if (context.cancelled) throw stopped();
    throw;
  }
}

std::string flags_of(const bench::Benchmark& benchmark) {
  std::string flags;
  for (const std::string_view flag : benchmark.options) flags += std::string(flag) + ", ";
  return flags + "--threads, --json";
}

/// A flag that a benchmark does not take would be ignored without a word.
void refuse_foreign_flags(const bench::Benchmark& benchmark, const BenchOptions& options) {
  for (const auto& [name, flag] : options.own)
    if (flag.given() && std::find(benchmark.options.begin(), benchmark.options.end(), name) == benchmark.options.end())
      throw usage_error(name, fmt::format("is not an option of bench {}", benchmark.name), flags_of(benchmark));
}

std::string benchmarks_help() {
  std::string text = "Benchmarks, and the options that each of them takes besides --threads and --json:\n";
  for (const bench::Benchmark& benchmark : bench::benchmarks()) {
    std::string flags;
    for (const std::string_view flag : benchmark.options) flags.append(" ").append(flag);
    text += fmt::format("  {:<10} {}\n", benchmark.name, benchmark.description);
    if (!flags.empty()) text += fmt::format("  {:<10}{}\n", "", flags);
  }
  return text;
}

/// The exit code: 1 where a check failed.
int report_failed(const bench::Report& report) {
  for (const std::string& failed : report.failed_checks) print_error("failed: {}\n", failed);
  return report.failed_checks.empty() ? 0 : 1;
}

int run(const BenchOptions& options, Context& context) {
  const bench::Benchmark& benchmark = find_benchmark(options.name);
  refuse_foreign_flags(benchmark, options);
  context.threads = options.threads;
  const bench::Report report = run_to_the_end(benchmark, options.request, context);
  if (!options.json) {
    if (report.text.empty())
      print_table(report);
    else
      fmt::print("{}\n{} checks of results passed\n", report.text, report.passed_checks);
    return report_failed(report);
  }
  nlohmann::ordered_json result{{"bench", benchmark.name},
                                {"machine", describe_machine(context)},
                                {"rows", report.rows},
                                {"passed_checks", report.passed_checks}};
  if (!report.details.is_null()) result["details"] = report.details;
  print_json(result);
  return report_failed(report);
}

}  // namespace

void add_bench_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<BenchOptions>();
  bench::Request& request = options->request;
  request.say = [](std::string_view line) { print_error("{}\n", line); };
  const Command command = root.add_command("bench", "Measure speed on this machine, after checking the results");
  command.footer(benchmarks_help());
  command.add_option("NAME", options->name, "The benchmark").required();
  const auto own = [&](const char* name, const Flag& flag) { options->own.emplace_back(name, flag); };
  own("--scene",
      command
          .add_option("SCENE,--scene", request.scenes,
                      "Measure only these scenes: names of built-in scenes, files, or for light the rows that --list "
                      "names; repeat --scene for more")
          .type_name("SCENE"));
  own("--list", command.add_flag("--list", request.list, "List the rows and measure nothing"));
  own("--pictures", command
                        .add_option("--pictures", request.pictures,
                                    "Also write the compared pictures and their errors as PNG files into this folder")
                        .type_name("DIR"));
  own("--tachyon-scenes", command.add_option("--tachyon-scenes", request.tachyon_scenes, "The folder of Tachyon's own scenes")
                              .type_name("DIR")
                              .show_default());
  own("--frames", command
                      .add_option("--frames", request.frames,
                                  "Number of frames of each animation; 0: 48 (24 of Tachyon's), light 3, estimates 4")
                      .type_name("N")
                      .not_negative());
  own("--views", command
                     .add_option("--views", request.views,
                                 "Views across and up, in place of each row's own optics; with --view-pixels, 3x1 by default")
                     .type_name("CxR"));
  own("--view-pixels", command
                           .add_option("--view-pixels", request.view_pixels,
                                       "Width and height of each view; 0: 120 with --views, else each row's own optics")
                           .type_name("N")
                           .range(0, 4096));
  own("--large", command.add_flag("--large", request.large, "Also measure the teapot at 3840x2160 pixels"));
  own("--quick", command.add_flag("--quick", request.quick, "Measure a few small frames, to see that the benchmark works"));
  own("--reference-spp",
      command.add_option("--reference-spp", request.reference_spp, "Samples per pixel of the reference pictures; 0: 1024")
          .type_name("N")
          .range(0, 1 << 20));
  own("--references", command
                          .add_option("--references", request.references,
                                      "The folder that keeps the reference pictures; default: lippmann/references in the "
                                      "user's cache")
                          .type_name("DIR"));
  own("--plot", command.add_option("--plot", request.plot, "Also draw plots as PNG files into this folder").type_name("DIR"));
  own("--csv", command.add_option("--csv", request.csv, "Also write the summary, one row per scene, as CSV").type_name("FILE"));
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  command.add_flag("--json", options->json, "Print the result as JSON");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
