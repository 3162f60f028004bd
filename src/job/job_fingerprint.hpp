#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "job/resolved_job.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Returns 16 hexadecimal digits that identify everything that affects the pictures: parameters, scene, display and
/// version of this program.
std::string job_fingerprint(const ResolvedJob& job, const Scene& scene, const Display* display = nullptr);

/// Returns the names of parameters that affect pictures and differ between a job file and `job`. Returns nothing if the
/// file cannot be read.
std::vector<std::string> differences(const std::filesystem::path& job_file, const ResolvedJob& job);

}  // namespace lippmann
