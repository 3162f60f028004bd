#include "job/finished_frames.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/fingerprint.hpp"
#include "core/json_text.hpp"
#include "display/display_json.hpp"
#include "job/params_table.hpp"
#include "job/render_folder.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/version.hpp"
#include "scene/fingerprint.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

bool are_as_recorded(const fs::path& folder, const FileRecords& files, const std::vector<fs::path>& pictures) {
  const auto is_recorded = [&](const fs::path& path) { return files.contains(path.lexically_relative(folder).string()); };
  const auto is_as_recorded = [&](const auto& file) { return file_checksum(folder / file.first) == file.second; };
  return std::all_of(pictures.begin(), pictures.end(), is_recorded) && std::all_of(files.begin(), files.end(), is_as_recorded);
}

/// Of which another render of the same job, begun at the same time, may have been faster.
void begin_journal(const fs::path& path, const std::string& job) {
  const std::string line = job_line(job);
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  const bool is_written = descriptor >= 0 && ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int problem = errno;
  if (descriptor >= 0) close(descriptor);
  if (!is_written && problem != EEXIST)
    throw Error(path.string(), fmt::format("cannot be written ({})", std::strerror(problem)));
}

}  // namespace

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

FinishedFrames::FinishedFrames(fs::path folder, const std::string& job, FrameNames names)
    : folder_(std::move(folder)), path_(journal_path(folder_)), names_(std::move(names)) {
  std::optional<FolderJournal> journal = read_journal(folder_);
  if (!journal) {
    begin_journal(path_, job);
    journal = read_journal(folder_);
  }
  require_sound(folder_, journal.value());
  if (journal->job != job) throw Error(folder_.string(), "holds another render", "another folder");
  before_ = std::move(*journal);
  std::error_code ignored;
  if (fs::file_size(path_, ignored) > before_.sound_bytes) fs::resize_file(path_, before_.sound_bytes, ignored);
  out_.open(path_, std::ios::app);
}

std::optional<FrameReport> FinishedFrames::find(int frame) {
  const auto found = before_.frames.find(frame);
  if (found == before_.frames.end()) return std::nullopt;
  const auto [read, is_new] = is_as_recorded_.emplace(frame, false);
  if (is_new) read->second = are_as_recorded(folder_, found->second.files, picture_paths(folder_, names_, frame));
  return read->second ? std::optional(found->second.report) : std::nullopt;
}

void FinishedFrames::add_file(const std::string& name) {
  write(written_line(name, records_of(folder_, {folder_ / name}).begin()->second));
}

void FinishedFrames::remove_file(const std::string& name) {
  std::error_code problem;
  if (fs::remove(folder_ / name, problem)) write(written_line(name, std::nullopt));
  if (problem) throw Error((folder_ / name).string(), "cannot be removed (" + problem.message() + ")");
}

void FinishedFrames::begin_video(const fs::path& video, const std::vector<int>& frames) {
  write(video_line(video_name(folder_, video), {std::nullopt, frames}));
}

void FinishedFrames::add_video(const fs::path& video, const std::vector<int>& frames) {
  const std::optional<FileChecksum> sum = file_checksum(video);
  if (!sum) throw Error(video.string(), "cannot be read back to take its checksum");
  write(video_line(video_name(folder_, video), {sum, frames}));
}

void FinishedFrames::write(const std::string& line) {
  out_ << line << std::flush;
  if (!out_) throw Error(path_.string(), fmt::format("cannot be written ({})", std::strerror(errno)));
}

}  // namespace lippmann
