// Parses the command line, runs the one command that it names, and turns every failure into one message and an exit code:
// 0 done, 1 the work failed (bad input, I/O), 2 wrong usage, 128 + n stopped by signal n.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/interrupt.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"

namespace lippmann::app {
namespace {

constexpr int kFailed = 1, kWrongUsage = 2;

/// What was meant by a word that nothing on the command line takes: the nearest flag of the command, or command.
std::string suggestion(const std::string& word, const CLI::App& command) {
  std::vector<std::string> names;
  if (word.starts_with("-")) {
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  } else {
    for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; })) names.push_back(sub->get_name());
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string nearest = nearest_name(word.substr(0, word.find('=')), candidates);
  return nearest.empty() ? std::string() : fmt::format(", did you mean '{}'?", nearest);
}

/// CLI11's own answer: help and version are results (stdout, 0), anything else is a message (stderr, 2).
int report(const CLI::ParseError& outcome, const CLI::App& root) {
  if (outcome.get_exit_code() == 0) return root.exit(outcome);
  const CLI::App* command = &root;
  std::string name = "lippmann";
  for (const CLI::App* chosen : root.get_subcommands()) command = chosen, name += " " + chosen->get_name();
  std::string problem = outcome.what();
  for (const std::string& word : root.remaining(true)) {
    if (!word.starts_with("-") && command != &root) continue;
    problem = fmt::format("there is no '{}'{}", word, suggestion(word, *command));
    break;
  }
  fmt::print(stderr, "{}: {} (see {} --help)\n", name, problem, name);
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
  add_convert_command(root, chosen);
  add_encode_command(root, chosen);
  add_replay_command(root, chosen);
  add_info_command(root, chosen);
  add_scenes_command(root, chosen);
  add_displays_command(root, chosen);
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
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is an error of writing like a full disk, with its message
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
