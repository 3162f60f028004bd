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

/// Reads the keys of a job file into `params`; parameters without a key keep their values. Throws Error naming the file, the
/// line and, for an unknown key, the most similar known key.
void read_job(const std::filesystem::path& file, RenderParams& params);

/// Returns the text of a job file in `folder`. It has a key for every parameter that is set, below the heading of the
/// parameter's group.
std::string job_text(const RenderParams& params, const std::filesystem::path& folder);

/// Writes job_text() atomically.
void write_job(const std::filesystem::path& file, const RenderParams& params);

}  // namespace lippmann
