// Describes a job for clusters and render farms: as a Slurm script, an Open Job Description template, or plain
// commands. Each task of the cluster renders one unit of the job.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lippmann {

struct Submission {
  std::filesystem::path program;  ///< absolute path of the command-line tool, or a name in PATH
  std::filesystem::path job;      ///< absolute path of a job file
  std::filesystem::path folder;   ///< absolute path of the job's output folder
  std::string name;               ///< name of the job in the scheduler's lists
  int units = 1;
  int chunk = 1;  ///< units that one task renders in sequence, if the scheduler supports such tasks
  int threads = 1;
  std::optional<int> minutes = {};                 ///< time limit of a task; nullopt: the default of the scheduler
  std::optional<std::uint64_t> memory_bytes = {};  ///< memory limit of a task in bytes; nullopt: the default of the scheduler
  /// Memory limit of the task that finishes the job, if joining strips needs more than `memory_bytes`.
  std::optional<std::uint64_t> finish_memory_bytes = {};
  std::string partition = {};  ///< empty for the default of Slurm
};

/// Returns the time limit of a unit in minutes: 5 minutes plus 3 times the estimate cpu_seconds / threads. The margin is for
/// busy or slow machines.
int minutes_for(double cpu_seconds, int threads);

/// Returns the memory limit of a unit in bytes: 1.5 times the estimated peak.
std::uint64_t memory_for(std::uint64_t peak_memory_bytes);

/// Returns a script that submits an array job over the units, and a job that finishes the folder after all units have
/// succeeded. A requeued task keeps its finished frames.
std::string slurm_script(const Submission& submission);

/// Returns an Open Job Description template (jobtemplate-2023-09) as JSON, with one step that renders the units, and a second
/// step that finishes the folder. If chunk > 1, the tasks are of type CHUNK[INT] (extension TASK_CHUNKING).
std::string openjd_template(const Submission& submission);

/// Returns one command per line. The commands of the units come first and may run in any order and on any machines; the
/// last command must run after all of them.
std::string shell_commands(const Submission& submission);

}  // namespace lippmann
