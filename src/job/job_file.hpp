// Reads and writes job files: TOML with the keys of params_table.hpp, which reproduces a render. Paths in a job file are
// relative to its folder; paths in RenderParams are relative to the working folder. If a job file lies in the output folder of
// its own render, paths inside this folder are stored relative to the file, so that a copy of the folder renders into the copy.
#pragma once

#include <filesystem>
#include <string>

#include "job/params.hpp"

namespace lippmann {

/// Reads the keys of a job file into `params`. Parameters without a key keep their values. Throws Error that names the
/// file and the line, and for an unknown key the most similar known one.
void read_job(const std::filesystem::path& file, RenderParams& params);

/// Returns the text of a job file in `folder`, with a key for every parameter that is set.
std::string job_text(const RenderParams& params, const std::filesystem::path& folder);

void write_job(const std::filesystem::path& file, const RenderParams& params);

}  // namespace lippmann
