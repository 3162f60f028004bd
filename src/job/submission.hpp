// Submits a job in units to clusters and render farms: a Slurm script, an Open Job Description template, or plain commands.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lippmann {

struct Submission {
  std::filesystem::path program;  ///< the command-line tool, as an absolute path or a name in PATH
  std::filesystem::path job;      ///< a job file, absolute
  std::filesystem::path folder;   ///< the output folder of the job, absolute
  std::string name;               ///< name of the job, for lists
  int units = 1;
  int chunk = 1;                    ///< number of units that a task renders in sequence, if the scheduler supports such tasks
  int threads = 1;                  ///< threads of each task
  std::optional<int> minutes = {};  ///< time limit of a task; none: the scheduler's default
  std::optional<std::uint64_t> memory_bytes = {};  ///< memory limit of a task; none: the scheduler's default
  /// Memory limit of the finishing task, if joining strips needs more than `memory_bytes`.
  std::optional<std::uint64_t> finish_memory_bytes = {};
  std::string partition = {};  ///< Slurm partition; empty: the default of Slurm
};

/// Returns a time limit for units that need `cpu_seconds`: three times the estimate plus five minutes, to allow for busy or
/// slower machines.
int minutes_for(double cpu_seconds, int threads);

/// Returns a memory limit: one and a half times the estimate.
std::uint64_t memory_for(std::uint64_t peak_memory_bytes);

/// Returns a script that submits an array job over the units, and a job that finishes the folder after all units have
/// succeeded. Tasks may be requeued at any time; a requeued task keeps the frames that it has finished.
std::string slurm_script(const Submission& submission);

/// Returns an Open Job Description template (jobtemplate-2023-09) as JSON, with one step over the units and a step that
/// finishes the folder after it. If chunk > 1, the tasks are of type CHUNK[INT] (extension TASK_CHUNKING).
std::string openjd_template(const Submission& submission);

/// Returns one command per line: first the units, which may run in any order and on any machines; last the command to run after
/// all of them.
std::string shell_commands(const Submission& submission);

}  // namespace lippmann
