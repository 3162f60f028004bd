// Job files: TOML whose keys are the names in params_table.hpp. A job reproduces a render.
//
// Paths in a job file are relative to the folder that it lies in; in RenderParams they are relative to the working folder. In
// the folder of its render, a job file names that folder and what lies in it relative to itself, however it was given: a copy
// of the folder renders into itself.
#pragma once

#include <filesystem>
#include <string>

#include "job/params.hpp"

namespace lippmann {

/// Reads the keys of a job over `params`. Throws Error naming file, line and, for an unknown key, the nearest known one.
void read_job(const std::filesystem::path& file, RenderParams& params);

/// The text of a job file in `folder` that gives these params: every key that is given, under its group's heading.
std::string job_text(const RenderParams& params, const std::filesystem::path& folder);

/// Writes job_text(), whole or not at all.
void write_job(const std::filesystem::path& file, const RenderParams& params);

}  // namespace lippmann
