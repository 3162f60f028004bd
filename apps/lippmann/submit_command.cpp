// `lippmann submit JOB`: divides a job into parts, and writes tasks for Slurm, a render farm or a shell that render the parts.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <system_error>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/platform.hpp"
#include "core/printable.hpp"
#include "job/job_file.hpp"
#include "job/submission.hpp"
#include "job/unit_plan.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct SubmitOptions {
  std::string job, slurm, openjd, shell, partition, program;
  int units = 1, chunk = 1, threads = 0;
  std::optional<int> minutes, memory_mb;
  bool only_list = false;
  ResultFlags result;
};

/// Returns "lippmann" if the tool was found on PATH. Otherwise, returns its absolute path, because tasks may run in another
/// working folder.
fs::path program_of_tasks(const std::string& called_as) {
  if (called_as == "lippmann") return called_as;
  const fs::path self = platform::program_file();
  return self.empty() ? fs::path(called_as) : self;
}

void write_text(const fs::path& path, const std::string& text, bool is_script) {
  const NewFolder folder(path.parent_path());
  write_file_atomically(path, std::as_bytes(std::span(text)));
  std::error_code ignored;
  if (is_script) fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec, fs::perm_options::add, ignored);
}

Submission submission_of(const SubmitOptions& options, const Context& context) {
  RenderParams params;
  if (fs::path(options.job).extension() != ".toml")
    throw usage_error("JOB", options.job + " is not a job file",
                      "a .toml; lippmann render SCENE --dump-job FILE.toml writes one");
  read_job(options.job, params);
  params.threads = options.threads > 0 ? options.threads : params.threads > 0 ? params.threads : resolved_threads(context);
  const UnitPlan plan = plan_units(ResolvedJob(params), options.units, !options.only_list, context);
  Submission submission;
  submission.program = program_of_tasks(options.program);
  submission.job = fs::absolute(options.job).lexically_normal();
  submission.folder = fs::absolute(output_folder(params)).lexically_normal();
  submission.name = submission.job.stem().string();
  submission.units = static_cast<int>(plan.units.size());
  submission.chunk = options.chunk, submission.threads = params.threads, submission.partition = options.partition;
  if (plan.costs) {
    double longest = 0.0;
    for (const PlannedUnit& unit : plan.units) longest = std::max(longest, *unit.cpu_seconds);
    submission.minutes = minutes_for(options.chunk * longest, params.threads);
    submission.memory_bytes = memory_for(plan.costs->peak_memory_bytes);
  }
  if (plan.join_bytes) submission.finish_memory_bytes = memory_for(static_cast<std::uint64_t>(*plan.join_bytes));
  if (options.minutes) submission.minutes = options.minutes;
  if (options.memory_mb) submission.memory_bytes = std::uint64_t{1'000'000} * static_cast<std::uint64_t>(*options.memory_mb);
  return submission;
}

int run(const SubmitOptions& options, const Context& context) {
  if (options.slurm.empty() && options.openjd.empty() && options.shell.empty())
    throw usage_error("submit", "no output is given", "--slurm FILE, --openjd FILE or --shell FILE");
  if (options.job.empty()) throw usage_error("JOB", "no job file is given", "a job file (.toml)");
  const Submission submission = submission_of(options, context);
  if (context.cancelled) return 1;
  if (!options.slurm.empty()) write_text(options.slurm, slurm_script(submission), true);
  if (!options.openjd.empty()) write_text(options.openjd, openjd_template(submission), false);
  if (!options.shell.empty()) write_text(options.shell, shell_commands(submission), true);
  if (options.result.json) {
    print_json({{"units", submission.units},
                {"folder", submission.folder.string()},
                {"minutes", submission.minutes ? nlohmann::ordered_json(*submission.minutes) : nullptr},
                {"memory_bytes", submission.memory_bytes ? nlohmann::ordered_json(*submission.memory_bytes) : nullptr}});
  } else if (options.result.wants_text()) {
    fmt::print("{} units into {}\n", submission.units, printable_line(submission.folder.string()));
    if (!options.slurm.empty()) fmt::print("  {:<9} bash {}\n", "submit", printable_line(shell_word(options.slurm)));
    if (!options.openjd.empty()) fmt::print("  {:<9} {}\n", "template", printable_line(options.openjd));
    if (!options.shell.empty()) fmt::print("  {:<9} {}\n", "commands", printable_line(options.shell));
  }
  return 0;
}

}  // namespace

void add_submit_command(const Command& root, Action& chosen, const std::string& program) {
  auto options = std::make_shared<SubmitOptions>();
  options->program = program;
  const Command command = root.add_command("submit", "Cut a job into units and write them for Slurm, a render farm or a shell");
  command.add_option("JOB", options->job, "A job file (.toml)");
  command.add_option("--units", options->units, "Number of units to cut the job into; a job of fewer parts has fewer")
      .required()
      .type_name("N")
      .range(1, 1'000'000);
  command.add_option("--slurm", options->slurm, "A script that submits an array job and a second job that finishes it")
      .type_name("FILE");
  command.add_option("--openjd", options->openjd, "An Open Job Description template (JSON), for render farms")
      .type_name("FILE");
  command.add_option("--shell", options->shell, "A file with one command per line, for any other farm").type_name("FILE");
  command
      .add_option("--chunk", options->chunk,
                  "With --openjd: number of units that a task renders one after the other; default: 1")
      .type_name("N")
      .range(1, 1'000'000);
  command
      .add_option("--threads", options->threads, "Processors of each task; default: the job's threads, or all of this machine")
      .type_name("N")
      .range(1, 1024);
  command.add_option("--partition", options->partition, "Slurm partition that the tasks run in; default: the cluster's")
      .type_name("NAME");
  command.add_option("--time", options->minutes, "Time limit of each task; default: from measured frames")
      .type_name("MINUTES")
      .range(1, 1'000'000);
  command.add_option("--memory", options->memory_mb, "Memory limit of each task; default: from measured frames")
      .type_name("MB")
      .range(1, 100'000'000);
  command.add_flag("--only-list", options->only_list, "Measure no frames: set only the limits that are given");
  add_result_flags(command, options->result, "Print nothing");
  command.footer(
      "Examples:\n"
      "  lippmann submit film.toml --units 200 --slurm film.sh && bash film.sh\n"
      "  lippmann submit film.toml --units 200 --openjd film.json --chunk 5\n");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
