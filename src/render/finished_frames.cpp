#include "render/finished_frames.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/fingerprint.hpp"
#include "core/json_text.hpp"
#include "display/display_json.hpp"
#include "render/params_table.hpp"
#include "scene/fingerprint.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) { return json_to_text(json, -1) + '\n'; }

std::string header_line(const std::string& fingerprint) { return line_of({{"job", fingerprint}}); }

std::string frame_line(const FrameReport& frame, std::uintmax_t bytes) {
  Json json = to_json(frame);
  json["picture_bytes"] = bytes;
  return line_of(json);
}

}  // namespace

std::string job_fingerprint(const RenderParams& params, const Scene& scene, const Display* display) {
  Fingerprint print;
  print.add(LIPPMANN_VERSION);
  for (const ParamInfo& info : params_table()) {
    if (!info.changes_pictures) continue;
    print.add(info.name);
    for (const std::string& value : info.get(params)) print.add(value);
  }
  print.add(fingerprint(scene));
  if (display) print.add(json_to_text(display_json(*display), -1));
  return fmt::format("{:016x}", print.value());
}

FinishedFrames::FinishedFrames(fs::path folder, std::string fingerprint, FrameNames names)
    : folder_(std::move(folder)), journal_(folder_ / ".lippmann-frames.jsonl"), names_(std::move(names)) {
  std::string journal = header_line(fingerprint);
  std::ifstream old(journal_);
  std::string line;
  const bool any_job = static_cast<bool>(std::getline(old, line)), same_job = any_job && line + '\n' == journal;
  took_over_ = any_job && !same_job;
  while (same_job && std::getline(old, line)) {
    const Json json = json_from_text(line);
    const std::optional<FrameReport> frame = frame_report_from_json(json);
    if (!frame || !json.contains("picture_bytes")) continue;
    if (json["picture_bytes"] != picture_bytes(folder_, names_, frame->frame)) continue;
    finished_[frame->frame] = *frame;
    journal += line + '\n';
  }
  write_file_atomically(journal_, std::as_bytes(std::span(journal)));
  out_.open(journal_, std::ios::app);
}

std::optional<FrameReport> FinishedFrames::find(int frame) const {
  const auto found = finished_.find(frame);
  return found == finished_.end() ? std::nullopt : std::optional(found->second);
}

void FinishedFrames::add(const FrameReport& frame) {
  out_ << frame_line(frame, picture_bytes(folder_, names_, frame.frame)) << std::flush;
  if (!out_) throw Error(journal_.string(), fmt::format("cannot be written ({})", std::strerror(errno)));
}

}  // namespace lippmann
