#include "job/job_fingerprint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "core/fingerprint.hpp"
#include "core/json_text.hpp"
#include "core/regular_file.hpp"
#include "display/display_json.hpp"
#include "job/job_file.hpp"
#include "job/params_table.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/version.hpp"
#include "scene/fingerprint.hpp"

namespace lippmann {

namespace fs = std::filesystem;

namespace {

std::optional<ResolvedJob> readable_job(const fs::path& file) try {
  if (!is_regular_file_there(file)) return std::nullopt;
  RenderParams params;
  read_job(file, params);
  return ResolvedJob(params);
} catch (const Error&) {
  return std::nullopt;
}

}  // namespace

std::string job_fingerprint(const ResolvedJob& job, const Scene& scene, const Display* display) {
  Fingerprint print;
  print.add(version());
  for (const ParamInfo& info : params_table()) {
    if (!info.changes_pictures) continue;
    print.add(info.name);
    for (const std::string& value : info.get(job.params())) print.add(value);
  }
  print.add(fingerprint(scene));
  if (display) print.add(json_to_text(display_json(*display), -1));
  return fmt::format("{:016x}", print.value());
}

std::vector<std::string> differences(const fs::path& job_file, const ResolvedJob& job) {
  constexpr std::array<std::string_view, 10> kOnlyRun{"frames", "output", "video",   "video-codec", "crf",
                                                      "also",   "page",   "threads", "resume",      "order"};
  std::vector<std::string> names;
  const std::optional<ResolvedJob> other = readable_job(job_file);
  if (!other) return names;
  for (const ParamInfo& info : params_table())
    if (std::find(kOnlyRun.begin(), kOnlyRun.end(), info.name) == kOnlyRun.end() &&
        info.get(other->params()) != info.get(job.params()))
      names.emplace_back(info.name);
  return names;
}

}  // namespace lippmann
