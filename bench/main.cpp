// lippmann-bench NAME runs one benchmark and prints its rows as a table or as JSON.
//
// Exit codes: 0 for success, 1 if the benchmark or one of its checks failed, 2 for wrong usage, 128 + n if stopped by signal n.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "apps/lippmann/interrupt.hpp"
#include "apps/lippmann/print.hpp"
#include "bench/bench.hpp"
#include "bench/print_report.hpp"
#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "lippmann/core/version.hpp"

namespace lippmann::bench {
namespace {

using app::print_error;

constexpr int kFailed = 1, kWrongUsage = 2;

struct Options {
  Request request;
  int threads = 0;
  bool json = false;
};

void declare_options(CLI::App& root, Options& options) {
  root.set_help_flag("-h,--help", "Print this help and exit");
  root.set_version_flag("-v,-V,--version", fmt::format("lippmann-bench {}", version()), "Print the version and exit");
  root.require_subcommand(1);
  root.get_formatter()->label("SUBCOMMAND", "NAME");
  for (const Benchmark& benchmark : benchmarks()) {
    CLI::App* command = root.add_subcommand(std::string(benchmark.name), std::string(benchmark.description));
    command->group("Benchmarks");
    benchmark.add_options(*command, options.request);
    command->add_option("--threads", options.threads, "Worker threads; 0: one per processor")
        ->type_name("N")
        ->check(CLI::Range(0, 4096));
    command->add_flag("--json", options.json, "Print the result as JSON");
  }
  root.footer("lippmann-bench NAME --help explains the options of one benchmark.");
}

Error unknown_benchmark(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Benchmark& benchmark : benchmarks()) names.push_back(benchmark.name);
  return usage_error(name, "there is no such benchmark" + did_you_mean(name, names), fmt::format("{}", fmt::join(names, ", ")));
}

Error foreign_option(const std::string& option, const CLI::App& command) {
  std::vector<std::string> accepted;
  for (const CLI::Option* own : command.get_options()) accepted.push_back("--" + own->get_lnames().front());
  return usage_error(option, "is not an option of " + command.get_name(), fmt::format("{}", fmt::join(accepted, ", ")));
}

Error wrong_usage(const CLI::App& root, const CLI::ParseError& refusal) {
  const std::vector<std::string> words = root.remaining(), all_words = root.remaining(true);
  const std::vector<const CLI::App*> commands = root.get_subcommands([](const CLI::App* app) { return app->parsed(); });
  if (!words.empty()) return unknown_benchmark(words.front());
  if (commands.empty()) return usage_error("NAME", refusal.what());
  if (!all_words.empty()) return foreign_option(all_words.front(), *commands.front());
  return usage_error(commands.front()->get_name(), refusal.what());
}

/// Throws interrupted() if the benchmark was cancelled, because frames that were stopped half-way give meaningless results.
Report run_to_the_end(const Benchmark& benchmark, const Request& request, const Context& context) {
  try {
    Report report = benchmark.run(request, context);
    if (context.cancelled) throw interrupted();
    return report;
  } catch (const std::exception&) {
    if (context.cancelled) throw interrupted();
    throw;
  }
}

int run_benchmark(const std::string& name, const Options& options, const Context& context) {
  const auto benchmark = std::find_if(benchmarks().begin(), benchmarks().end(), [&](const auto& b) { return b.name == name; });
  const Report report = run_to_the_end(*benchmark, options.request, context);
  if (options.json)
    print_json(name, report, context);
  else
    print_table(report);
  for (const std::string& failed : report.failed_checks) print_error("failed: {}\n", failed);
  return report.failed_checks.empty() ? 0 : kFailed;
}

int run(int argc, char** argv) {
  CLI::App root("Benchmarks of Lippmann. Each one checks its results first, then measures them on this machine.",
                "lippmann-bench");
  Options options;
  declare_options(root, options);
  if (argc < 2) {
    print_error("{}", root.help());
    return kWrongUsage;
  }
  try {
    root.parse(argc, argv);
  } catch (const CLI::ParseError& outcome) {
    if (outcome.get_exit_code() != 0) throw wrong_usage(root, outcome);
    return root.exit(outcome);
  }
  Context context;
  context.threads = options.threads;
  std::mutex warning_mutex;
  std::set<std::string> warnings;  // a scene that is loaded several times repeats its warnings
  context.warn = [&](std::string_view text) {
    const std::lock_guard lock(warning_mutex);
    if (warnings.emplace(text).second) print_error("warning: {}\n", printable_line(text));
  };
  options.request.say = [](std::string_view line) { print_error("{}\n", line); };
  const app::InterruptGuard interrupt_guard(context.cancelled);
  return run_benchmark(root.get_subcommands().front()->get_name(), options, context);
}

int run_and_report(int argc, char** argv) {
  try {
    const int code = run(argc, argv);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    print_error("lippmann-bench: cannot write the result to standard output\n");
  } catch (const Error& error) {
    print_error("lippmann-bench: {}\n", error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    print_error("lippmann-bench: {}\n", printable_line(error.what()));
  }
  return kFailed;
}

}  // namespace
}  // namespace lippmann::bench

int main(int argc, char** argv) {
  const int code = lippmann::bench::run_and_report(argc, argv), interrupted = lippmann::app::InterruptGuard::exit_code();
  return interrupted != 0 ? interrupted : code;
}
