// Job files: TOML whose keys are the names in params_table.hpp. A job reproduces a render.
//
// Paths in a job file are relative to the file's folder. In RenderParams they are relative to the working folder. A job file in
// its render's folder stores that folder and the paths inside it relative to itself, even if they were given as absolute paths,
// so a copy of the folder renders into itself.
#pragma once

#include <filesystem>
#include <string>

#include "job/params.hpp"

namespace lippmann {

/// Reads the keys of a job into `params`; other parameters keep their values. Throws Error naming file, line and, for an
/// unknown key, the nearest known one.
void read_job(const std::filesystem::path& file, RenderParams& params);

/// Returns the text of a job file in `folder`: every given key, under its group's heading.
std::string job_text(const RenderParams& params, const std::filesystem::path& folder);

/// Writes job_text() atomically.
void write_job(const std::filesystem::path& file, const RenderParams& params);

}  // namespace lippmann
