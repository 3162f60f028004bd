// A job cut into units, as what clusters and farms take: a script for Slurm, an Open Job Description template, plain commands.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lippmann {

struct Submission {
  std::filesystem::path program;  ///< the tool, absolute or to be found by name
  std::filesystem::path job;      ///< a job file, absolute
  std::filesystem::path folder;   ///< that the job renders into, absolute
  std::string name;               ///< the job's, for lists
  int units = 1;
  int chunk = 1;                    ///< units that a task renders one after the other, where the scheduler may choose
  int threads = 1;                  ///< each task's
  std::optional<int> minutes = {};  ///< a task's limit; none: the scheduler's
  std::optional<std::uint64_t> memory_bytes = {};         ///< the same
  std::optional<std::uint64_t> finish_memory_bytes = {};  ///< the finishing task's, where it needs more: it joins strips
  std::string partition = {};                             ///< where Slurm is to run it; empty: its default
};

/// A limit of time that units of so many CPU seconds keep on busy and slower machines: three times as long, and five minutes.
int minutes_for(double cpu_seconds, int threads);

/// The same of memory: half as much again.
std::uint64_t memory_for(std::uint64_t peak_memory_bytes);

/// A script that submits an array job over the units and one that finishes the folder once all have succeeded. Tasks may be
/// requeued at any time: they go on after their finished frames.
std::string slurm_script(const Submission& submission);

/// An Open Job Description template (jobtemplate-2023-09), JSON: a step over the units and one that depends on it. chunk > 1:
/// tasks are CHUNK[INT] (extension TASK_CHUNKING).
std::string openjd_template(const Submission& submission);

/// One command a line: the units, in any order, on any machines; the last line when all are done.
std::string shell_commands(const Submission& submission);

}  // namespace lippmann
