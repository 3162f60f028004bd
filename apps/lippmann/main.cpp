// Parses the command line and runs the command that it names. Exit codes: 0 done, 1 failed (bad input, I/O), 2 wrong usage, 128
// + n stopped by signal n.
#include <fmt/core.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "apps/lippmann/build_facts.hpp"
#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/interrupt.hpp"
#include "apps/lippmann/print.hpp"
#include "core/platform.hpp"
#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/version.hpp"

namespace lippmann::app {
namespace {

constexpr int kFailed = 1;  ///< exit code

/// Returns the path by which the tool was called, or "lippmann" if it was called without a path. Commands that the tool prints
/// begin with this name, so that the user can run them.
std::string program_name(int argc, char** argv) {
  const std::string_view word = argc > 0 ? argv[0] : "";
  return word.find('/') == std::string_view::npos ? "lippmann" : shell_word(word);
}

/// Prints commands to begin with, for a command line without a command. Returns the exit code.
int suggest_commands(const std::string& program) {
  print_error(
      "lippmann: no command is given; commands to begin with:\n"
      "  {0} render teapot      renders a built-in scene, or a file such as chair.glb, into out/teapot\n"
      "  {0} view out/teapot    shows the result in the browser\n"
      "  {0} view room          sets a scene up in the browser, and renders it\n"
      "All commands: {0} --help\n",
      program);
  return kWrongUsage;
}

/// Checks the stack limit, which also applies to threads: a thread whose stack is too small ends the process without a message.
void check_stack_limit() {
  constexpr std::uint64_t kLeastBytes = std::uint64_t{512} << 10;  // twice the 256 KB below which renders crash
  if (const std::optional<std::uint64_t> bytes = platform::stack_limit_bytes(); bytes && *bytes < kLeastBytes)
    throw Error("ulimit -s", fmt::format("the stack is limited to {} KB", *bytes >> 10),
                fmt::format("at least {} KB", kLeastBytes >> 10));
}

/// Returns `code`, or kFailed if standard output did not accept everything, as when the reader of a pipe has gone.
int code_after_flush(int code) {
  const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_written || code != 0) return code;
  print_error("lippmann: standard output: cannot be written, so the result is not printed in full\n");
  return kFailed;
}

/// Prints each warning once, even if reading a file twice repeats it.
class WarningPrinter {
 public:
  void print(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (printed_.insert(text).second) print_error("warning: {}\n", printable_line(text));
  }

 private:
  std::mutex mutex_;
  std::set<std::string> printed_;
};

int run_command(const CommandLine& command_line, const Action& chosen, Context& context) {
  try {
    return chosen(context);
  } catch (const Error& error) {
    print_error("lippmann: {}\n", command_line.message_of(error));
    return error.exit_code();
  }
}

bool names_bench(int argc, char** argv) {
  const int command = argc > 1 && std::string_view(argv[1]) == "help" ? 2 : 1;
  return command < argc && std::string_view(argv[command]) == "bench";
}

int run(int argc, char** argv) {
  check_stack_limit();
  if (names_bench(argc, argv)) {
    print_error(
        "lippmann: `bench` is a program of its own: lippmann-bench NAME (build it with scripts/build release "
        "lippmann-bench)\n");
    return kWrongUsage;
  }
  if (argc < 2) return suggest_commands(program_name(argc, argv));
  CommandLine command_line("lippmann", "Renders 3D integral images (light-field images) and their animation.",
                           fmt::format("lippmann {}\n{}", version(), build_facts()));
  const Command root = command_line.root();
  Action chosen;
  add_render_command(root, chosen, program_name(argc, argv));
  add_plan_command(root, chosen);
  add_dataset_command(root, chosen);
  add_submit_command(root, chosen, program_name(argc, argv));
  add_finish_command(root, chosen, program_name(argc, argv));
  add_check_command(root, chosen);
  add_compare_command(root, chosen);
  add_convert_command(root, chosen);
  add_align_command(root, chosen);
  add_encode_command(root, chosen);
  add_replay_command(root, chosen);
  add_report_command(root, chosen);
  add_view_command(root, chosen);
  add_play_command(root, chosen);
  add_info_command(root, chosen);
  add_scenes_command(root, chosen);
  add_displays_command(root, chosen);
  add_sheet_command(root, chosen);
  add_complete_command(root, chosen, command_line);
  add_manual_command(root, chosen, command_line);
  if (const std::optional<int> done = command_line.parse(argc, argv)) return *done;
  Context context;
  context.warn = [printer = std::make_shared<WarningPrinter>()](std::string_view text) { printer->print(with_flags(text)); };
  const InterruptGuard interrupt(context.cancelled);
  const int code = run_command(command_line, chosen, context);
  const int interrupted = InterruptGuard::exit_code();
  return interrupted != 0 ? interrupted : code;
}

}  // namespace
}  // namespace lippmann::app

int main(int argc, char** argv) {
  lippmann::platform::open_missing_streams();
  lippmann::platform::ignore_write_signals();
  try {
    return lippmann::app::code_after_flush(lippmann::app::run(argc, argv));
  } catch (const lippmann::Error& error) {
    lippmann::app::print_error("lippmann: {}\n", error.what());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    lippmann::app::print_error("lippmann: out of memory\n");
  } catch (const std::exception& error) {
    lippmann::app::print_error("lippmann: {}\n", lippmann::printable_line(error.what()));
  }
  return lippmann::app::kFailed;
}
