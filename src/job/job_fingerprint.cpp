#include "job/job_fingerprint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
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

std::string job_fingerprint(const RenderParams& params, const Scene& scene, const Display* display) {
  Fingerprint print;
  print.add(version());
  for (const ParamInfo& info : params_table()) {
    if (!info.changes_pictures) continue;
    print.add(info.name);
    for (const std::string& value : info.get(params)) print.add(value);
  }
  print.add(fingerprint(scene));
  if (display) print.add(json_to_text(display_json(*display), -1));
  return fmt::format("{:016x}", print.value());
}

std::vector<std::string> differences(const fs::path& job_file, const RenderParams& params) {
  constexpr std::array<std::string_view, 10> kOnlyRun{"frames", "output", "video",   "video-codec", "crf",
                                                      "also",   "page",   "threads", "resume",      "order"};
  RenderParams other;
  std::vector<std::string> names;
  try {
    if (!is_regular_file_there(job_file)) return {};
    read_job(job_file, other);
  } catch (const Error&) {
    return {};
  }
  other = with_scene_defaults(other);
  for (const ParamInfo& info : params_table())
    if (std::find(kOnlyRun.begin(), kOnlyRun.end(), info.name) == kOnlyRun.end() && info.get(other) != info.get(params))
      names.emplace_back(info.name);
  return names;
}

}  // namespace lippmann
