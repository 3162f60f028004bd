// Reads and writes job files. A job file is TOML with the keys of params_table.hpp and reproduces a render.
//
// Paths in a job file are relative to the folder of the job file. Paths in RenderParams are relative to the working folder. If
// a job file lies in the output folder of its render, the output folder and all paths inside it are stored relative to the job
// file, even if they were given as absolute paths. A copy of the folder therefore renders into the copy.
#pragma once

#include <filesystem>
#include <string>

#include "job/params.hpp"

namespace lippmann {

/// Reads the keys of a job file into `params`. Parameters without a key keep their values. Throws Error that names the file and
/// the line. For an unknown key, the error also names the most similar known key.
void read_job(const std::filesystem::path& file, RenderParams& params);

/// Returns the text of a job file that lies in `folder`. The text has a key for every parameter that is set, below the heading
/// of the parameter's group.
std::string job_text(const RenderParams& params, const std::filesystem::path& folder);

/// Writes job_text() atomically.
void write_job(const std::filesystem::path& file, const RenderParams& params);

}  // namespace lippmann
