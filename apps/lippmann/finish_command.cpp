// `lippmann finish DIR`: checks whether a job rendered in parts is complete, and writes its videos and report.
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "apps/lippmann/write_page.hpp"
#include "core/frame_ranges.hpp"
#include "core/printable.hpp"
#include "job/finish_animation.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct FinishOptions {
  std::string folder, program;
  std::vector<std::string> join;
  ResultFlags result;
};

std::string numbers(const std::vector<int>& frames) { return write_frames(ranges_of(frames)); }

void print_problems(const FinishedAnimation& finished) {
  for (const std::string& file : finished.joined.not_as_written)
    fmt::print("not taken over  {}: its bytes have changed since they were written\n", printable_line(file));
  for (const std::string& name : finished.check.damaged) fmt::print("damaged  {}\n", printable_line(name));
  for (const std::string& name : finished.check.missing) fmt::print("missing  {}\n", printable_line(name));
  for (const auto& [frame, strips] : finished.check.strips_left)
    fmt::print("not rendered yet: strips {} of frame {}\n", numbers(strips), frame);
}

void print_result(const FinishOptions& options, const FinishedAnimation& finished) {
  if (!finished.joined.frames.empty()) fmt::print("taken over: frames {}\n", numbers(finished.joined.frames));
  const std::string job = printable_line(shell_word((fs::path(options.folder) / "job.toml").string()));
  if (!finished.report) {
    print_problems(finished);
    fmt::print("{} of {} frames have yet to be rendered: {}\n  {} render {} --resume\n", finished.to_render.size(),
               static_cast<std::size_t>(finished.check.frames) + finished.check.unfinished.size(), numbers(finished.to_render),
               options.program, job);
    return;
  }
  const RenderReport& report = *finished.report;
  if (!finished.has_single)
    return fmt::print("{}: all frames are rendered; {} has yet to be rendered\n  {} render {} --resume\n",
                      printable_line(options.folder), kSingleFolder, options.program, job);
  for (const std::string& video : report.videos) fmt::print("  {:<9} {}\n", "video", printable_line(video));
  fmt::print("  {:<9} {}\n", "figures", printable_line((fs::path(options.folder) / "report.json").string()));
  fmt::print("{}: all {} frames are intact\n", printable_line(options.folder), report.frames.size());
}

bool is_complete(const FinishedAnimation& finished) { return finished.report && finished.has_single; }

nlohmann::ordered_json result_json(const FinishOptions& options, const FinishedAnimation& finished) {
  return {{"folder", options.folder},
          {"finished", is_complete(finished)},
          {"frames", finished.check.frames},
          {"taken_over", finished.joined.frames},
          {"not_taken_over", finished.joined.not_as_written},
          {"to_render", finished.to_render},
          {"damaged", finished.check.damaged},
          {"missing", finished.check.missing},
          {"videos", finished.report ? finished.report->videos : std::vector<std::string>()}};
}

int run(const FinishOptions& options, const Context& context) {
  const FinishedAnimation finished = finish_animation(options.folder, {options.join.begin(), options.join.end()}, context);
  if (finished.report && finished.report->params.output.page) write_page(options.folder, context);
  if (options.result.json)
    print_json(result_json(options, finished));
  else if (options.result.wants_text())
    print_result(options, finished);
  return is_complete(finished) ? 0 : 1;
}

}  // namespace

void add_finish_command(const Command& root, Action& chosen, const std::string& program) {
  auto options = std::make_shared<FinishOptions>();
  options->program = program;
  const Command command =
      root.add_command("finish", "Complete a job that was rendered in parts: check all frames, write videos, page and report");
  command.add_option("DIR", options->folder, "The folder that the parts were rendered into").required();
  command
      .add_option("--join", options->join, "Folders of separately rendered parts, whose frames are first taken over into DIR")
      .type_name("DIR...");
  add_result_flags(command, options->result, "Print nothing: exit code 0 means that the job is complete");
  command.footer(
      "Every file is compared with its checksum. If frames are missing or damaged, the exit code is 1, nothing is finished,\n"
      "and the command that renders them is printed.\n"
      "Examples:\n"
      "  lippmann finish out/film                          after: lippmann render film.toml --unit 1/8, --unit 2/8, ...\n"
      "  lippmann finish film --join part-1 part-2         parts that were rendered into folders of their own\n");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
