// The commands of the tool, one file each.
//
// To add a command:
// 1. Write `add_NAME_command` in NAME_command.cpp, declare it below, and call it in main.cpp.
// 2. Allocate the options on the heap, because the command line keeps references to them.
// 3. Declare the flags.
// 4. When the command is named, assign the function that runs it to `chosen`:
//
//   struct Options { std::string scene; bool json = false; };
//   auto options = std::make_shared<Options>();
//   const Command command = root.add_command("info", "...");
//   command.add_option("SCENE", options->scene, "...").required();
//   command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
//
// The function returns the exit code (0) or throws Error. Only results and --json go to stdout; messages go to stderr.
#pragma once

#include <functional>
#include <string>

#include "lippmann/core/context.hpp"

namespace lippmann::app {

class Command;
class CommandLine;

/// Runs the chosen command. Returns the exit code of the process.
using Action = std::function<int(Context& context)>;

/// program: the name by which the user called the tool. The commands that the tool prints begin with this name.
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
/// command_line: the command line whose commands are completed or documented.
void add_complete_command(const Command& root, Action& chosen, const CommandLine& command_line);
void add_manual_command(const Command& root, Action& chosen, const CommandLine& command_line);

}  // namespace lippmann::app
