// Submits a job in units to clusters and render farms: a Slurm script, an Open Job Description template, or plain commands.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lippmann {

struct Submission {
  std::filesystem::path program;  ///< the tool, an absolute path or a name in PATH
  std::filesystem::path job;      ///< a job file, absolute
  std::filesystem::path folder;   ///< the output folder of the job, absolute
  std::string name;               ///< name of the job, for lists
  int units = 1;
  int chunk = 1;                                   ///< units that a task renders in sequence, if the scheduler may choose
  int threads = 1;                                 ///< of each task
  std::optional<int> minutes = {};                 ///< time limit of a task; none: the scheduler's
  std::optional<std::uint64_t> memory_bytes = {};  ///< memory limit of a task; none: the scheduler's
  std::optional<std::uint64_t> finish_memory_bytes = {};  ///< of the finishing task if it needs more, since it joins strips
  std::string partition = {};                             ///< Slurm partition; empty: its default
};

/// Returns a time limit for units with that many CPU seconds on busy or slower machines: three times the estimate plus five
/// minutes.
int minutes_for(double cpu_seconds, int threads);

/// Returns a memory limit: one and a half times the estimate.
std::uint64_t memory_for(std::uint64_t peak_memory_bytes);

/// Returns a script that submits an array job over the units, and a job that finishes the folder after all units have
/// succeeded. Tasks may be requeued at any time: they continue after their finished frames.
std::string slurm_script(const Submission& submission);

/// Returns an Open Job Description template (jobtemplate-2023-09) as JSON: a step over the units and a step that depends on it.
/// chunk > 1: tasks are CHUNK[INT] (extension TASK_CHUNKING).
std::string openjd_template(const Submission& submission);

/// Returns one command per line: the units, in any order and on any machines, and a last line to run after all of them.
std::string shell_commands(const Submission& submission);

}  // namespace lippmann
