#include "render/finished_frames.hpp"

#include <fmt/core.h>

#include <algorithm>
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
#include "core/text_pattern.hpp"
#include "display/display_json.hpp"
#include "render/params_table.hpp"
#include "scene/fingerprint.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string line_of(const Json& json) { return json_to_text(json, -1) + '\n'; }

std::string header_line(const std::string& fingerprint) { return line_of({{"job", fingerprint}}); }

std::string frame_line(const FrameReport& frame, const FileRecords& files) {
  Json json = to_json(frame);
  json["files"] = Json::object();
  for (const auto& [name, sum] : files) json["files"][name] = {{"bytes", sum.bytes}, {"xxh3", sum.xxh3}};
  return line_of(json);
}

/// Below the folder and nowhere else: a journal may have been written by anybody.
bool stays_inside(const fs::path& name) {
  return !name.empty() && name.is_relative() && std::find(name.begin(), name.end(), "..") == name.end();
}

/// Of one line of a journal; empty where it does not say them.
FileRecords records_from_json(const Json& json) try {
  FileRecords files;
  for (const auto& [name, sum] : json.at("files").items()) {
    if (!stays_inside(name)) return {};
    files[name] = {sum.at("bytes").get<std::uint64_t>(), sum.at("xxh3").get<std::string>()};
  }
  return files;
} catch (const nlohmann::json::exception&) {
  return {};
}

bool are_as_recorded(const fs::path& folder, const FileRecords& files) {
  const auto is_as_recorded = [&](const auto& file) { return file_checksum(folder / file.first) == file.second; };
  return std::all_of(files.begin(), files.end(), is_as_recorded);
}

fs::path journal_of(const fs::path& folder) { return folder / ".lippmann-frames.jsonl"; }

bool is_file(const fs::path& path) {
  std::error_code problem;
  return fs::is_regular_file(path, problem);
}

/// Whether a render writes files of that name.
bool is_of_a_frame(const fs::path& name) {
  static const TextPattern pattern("(?:frame|aov|view)_[0-9]+.*\\.(?:png|tif|exr|json)");
  return pattern.match(name.filename().string()).has_value();
}

std::vector<std::string> foreign_files(const fs::path& folder, const FileRecords& known) {
  std::vector<std::string> foreign;
  for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator(); ++entry) {
    const fs::path name = entry->path().lexically_relative(folder);
    const bool is_views = entry.depth() == 0 && name.string().starts_with("frame_");
    if (entry->is_directory() && !is_views) entry.disable_recursion_pending();
    if (!entry->is_directory() && is_of_a_frame(name) && !known.contains(name.string())) foreign.push_back(name.string());
  }
  std::sort(foreign.begin(), foreign.end());
  return foreign;
}

/// What the frames of an open journal name, and what every render writes beside them.
void remove_files_of(const fs::path& folder, std::istream& journal) {
  std::error_code ignored;
  const auto remove = [&](const fs::path& name) {
    if (!fs::is_directory(folder / name, ignored)) fs::remove(folder / name, ignored);
    if (name.has_parent_path()) fs::remove(folder / name.parent_path(), ignored);  // of views, once it is empty
  };
  std::string line;
  while (std::getline(journal, line))
    for (const auto& [name, sum] : records_from_json(json_from_text(line))) remove(name);
  for (const char* name : {"job.toml", "report.json"}) remove(name);
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

FileRecords records_of(const fs::path& folder, const std::vector<fs::path>& files) {
  FileRecords records;
  for (const fs::path& file : files) {
    const std::optional<FileChecksum> sum = file_checksum(file);
    if (!sum) throw Error(file.string(), "cannot be read back to take its checksum");
    records[file.lexically_relative(folder).string()] = *sum;
  }
  return records;
}

FolderCheck check_folder(const fs::path& folder) {
  const fs::path path = journal_of(folder);
  std::ifstream journal;
  if (is_file(path)) journal.open(path);
  std::string line;
  if (!std::getline(journal, line))
    throw Error(folder.string(), "holds no render that can be checked: there is no .lippmann-frames.jsonl in it",
                "a folder that lippmann render has written to");
  std::map<int, FileRecords> frames;  // a later line of a frame speaks of files that replaced the earlier ones
  while (std::getline(journal, line)) {
    const Json json = json_from_text(line);
    if (const auto frame = frame_report_from_json(json)) frames[frame->frame] = records_from_json(json);
  }
  FolderCheck check;
  FileRecords known;
  for (const auto& [frame, files] : frames) known.insert(files.begin(), files.end());
  check.frames = static_cast<int>(frames.size()), check.files = known.size();
  for (const auto& [name, sum] : known) {
    std::error_code problem;
    if (!fs::exists(fs::symlink_status(folder / name, problem)))
      check.missing.push_back(name);
    else if (file_checksum(folder / name) != sum)
      check.damaged.push_back(name);
  }
  check.foreign = foreign_files(folder, known);
  return check;
}

FinishedFrames::FinishedFrames(fs::path folder, std::string fingerprint, FrameNames names, OtherRender other)
    : folder_(std::move(folder)), journal_(journal_of(folder_)), names_(std::move(names)) {
  std::string journal = header_line(fingerprint);
  std::ifstream old;
  if (is_file(journal_)) old.open(journal_);
  std::string line;
  const bool any_job = static_cast<bool>(std::getline(old, line)), same_job = any_job && line + '\n' == journal;
  took_over_ = any_job && !same_job;
  if (took_over_ && other == OtherRender::kRefuse)
    throw Error(folder_.string(), "holds a render with other parameters, of another scene or by another version",
                "another folder (-o DIR); --force, which removes that render's files; the same parameters");
  if (took_over_) remove_files_of(folder_, old);
  while (same_job && std::getline(old, line)) {
    const Json json = json_from_text(line);
    const std::optional<FrameReport> frame = frame_report_from_json(json);
    if (!frame) continue;
    const FileRecords files = records_from_json(json);
    const std::vector<fs::path> pictures = picture_paths(folder_, names_, frame->frame);
    const auto is_recorded = [&](const fs::path& path) { return files.contains(path.lexically_relative(folder_).string()); };
    if (!std::all_of(pictures.begin(), pictures.end(), is_recorded) || !are_as_recorded(folder_, files)) continue;
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

void FinishedFrames::add(const FrameReport& frame, const FileRecords& files) {
  out_ << frame_line(frame, files) << std::flush;
  if (!out_) throw Error(journal_.string(), fmt::format("cannot be written ({})", std::strerror(errno)));
}

}  // namespace lippmann
