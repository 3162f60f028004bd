// Parses the command line, runs the one command that it names, and turns every failure into one message and an exit code:
// 0 done, 1 the work failed (bad input, I/O), 2 wrong usage, 128 + n stopped by signal n.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/interrupt.hpp"
#include "core/error.hpp"

namespace lippmann::app {
namespace {

constexpr int kFailed = 1, kWrongUsage = 2;

/// CLI11's own answer: help and version are results (stdout, 0), anything else is a message (stderr, 2).
int report(const CLI::ParseError& outcome, const CLI::App& root) {
  if (outcome.get_exit_code() == 0) return root.exit(outcome);
  std::string command = "lippmann";
  for (const CLI::App* chosen : root.get_subcommands()) command += " " + chosen->get_name();
  fmt::print(stderr, "{}: {} (see {} --help)\n", command, outcome.what(), command);
  return kWrongUsage;
}

int run(int argc, char** argv) {
  CLI::App root("Renders 3D integral images (light-field images) and their animation.", "lippmann");
  root.set_version_flag("--version", "lippmann " LIPPMANN_VERSION, "Print the version and exit");
  root.set_help_flag("-h,--help", "Print this help and exit");
  root.require_subcommand(1);
  Action chosen;
  add_render_command(root, chosen);
  add_compare_command(root, chosen);
  add_info_command(root, chosen);
  add_scenes_command(root, chosen);
  add_bench_command(root, chosen);
  try {
    root.parse(argc, argv);
  } catch (const CLI::ParseError& outcome) {
    return report(outcome, root);
  }
  Context context;
  context.warn = [](std::string_view text) { fmt::print(stderr, "warning: {}\n", text); };
  const InterruptGuard interrupt(context.cancelled);
  const int code = chosen(context);
  const int interrupted = InterruptGuard::exit_code();
  return interrupted != 0 ? interrupted : code;
}

}  // namespace
}  // namespace lippmann::app

int main(int argc, char** argv) {
  try {
    return lippmann::app::run(argc, argv);
  } catch (const lippmann::Error& error) {
    fmt::print(stderr, "lippmann: {}\n", error.what());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "lippmann: out of memory\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "lippmann: {}\n", error.what());
  }
  return lippmann::app::kFailed;
}
