// The commands of the tool, one file each: it declares the command's flags, and what runs once they are parsed. No logic here.
//
// To add a command: write `add_NAME_command` in NAME_command.cpp, declare it below, call it in main.cpp. Inside, make a
// struct of options on the heap (the command line keeps references to it), declare flags that write to it, and hand what is
// to run to `chosen`:
//
//   struct Options { std::string scene; bool json = false; };
//   auto options = std::make_shared<Options>();
//   const Command command = root.add_command("info", "...");
//   command.add_option("SCENE", options->scene, "...").required();
//   command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
//
// What runs returns the exit code (0), or throws Error: only main() catches. Results and --json go to stdout, and nothing else
// does; messages and progress go to stderr.
#pragma once

#include <functional>
#include <string>

#include "lippmann/core/context.hpp"

namespace lippmann::app {

class Command;      // command_line.hpp
class CommandLine;  // likewise

/// What the command line asked for: runs it and returns the exit code of the process.
using Action = std::function<int(Context& context)>;

/// `program`: how the tool was called, for the commands that the summary suggests.
void add_render_command(const Command& root, Action& chosen, const std::string& program);
void add_plan_command(const Command& root, Action& chosen);
void add_submit_command(const Command& root, Action& chosen, const std::string& program);
void add_finish_command(const Command& root, Action& chosen, const std::string& program);
void add_check_command(const Command& root, Action& chosen);
void add_compare_command(const Command& root, Action& chosen);
void add_dataset_command(const Command& root, Action& chosen);
void add_convert_command(const Command& root, Action& chosen);
void add_align_command(const Command& root, Action& chosen);
void add_encode_command(const Command& root, Action& chosen);
void add_info_command(const Command& root, Action& chosen);
void add_replay_command(const Command& root, Action& chosen);
void add_report_command(const Command& root, Action& chosen);
void add_scenes_command(const Command& root, Action& chosen);
void add_displays_command(const Command& root, Action& chosen);
void add_sheet_command(const Command& root, Action& chosen);
void add_view_command(const Command& root, Action& chosen);
void add_play_command(const Command& root, Action& chosen);
/// `command_line` is what these tell about.
void add_complete_command(const Command& root, Action& chosen, const CommandLine& command_line);
void add_manual_command(const Command& root, Action& chosen, const CommandLine& command_line);

}  // namespace lippmann::app
