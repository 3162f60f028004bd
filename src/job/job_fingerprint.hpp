// Tells jobs apart by all that decides their pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "job/resolved_job.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Identifies the parameters that change pictures, the scene, the display and this program's version: 16 hexadecimal digits.
std::string job_fingerprint(const ResolvedJob& job, const Scene& scene, const Display* display = nullptr);

/// The names of the parameters in which a job file and `job` differ, of those that decide pictures; none if the file cannot
/// be read.
std::vector<std::string> differences(const std::filesystem::path& job_file, const ResolvedJob& job);

}  // namespace lippmann
