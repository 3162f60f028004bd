#include "folder/journal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "core/folder_entries.hpp"
#include "core/frame_ranges.hpp"
#include "core/json_text.hpp"
#include "core/platform.hpp"
#include "core/printable.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "folder/frame_report_json.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"
#include "video/video_reader.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

using LineProblem = std::runtime_error;

std::string line_of(const Json& json) { return json_to_text(json, -1) + '\n'; }

Json checksum_json(const FileChecksum& sum) { return {{"bytes", sum.bytes}, {"xxh3", sum.xxh3}}; }

/// Values that the lines of frames and of strips have in common.
Json finished_json(const FrameReport& report, const FileRecords& files) {
  Json json = to_json(report);
  json["files"] = Json::object();
  for (const auto& [name, sum] : files) json["files"][name] = checksum_json(sum);
  return json;
}

FileChecksum checksum_from_json(const Json& json) {
  constexpr std::size_t kDigits = 16;
  const Json& bytes = json.at("bytes");
  FileChecksum sum{0, json.at("xxh3").get<std::string>()};
  if (!bytes.is_number_unsigned() || bytes.get<std::uint64_t>() > std::uint64_t{1} << 62)
    throw LineProblem("has an invalid file size");
  if (sum.xxh3.size() != kDigits || sum.xxh3.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw LineProblem("has an invalid XXH3 checksum");
  sum.bytes = bytes.get<std::uint64_t>();
  return sum;
}

std::vector<int> frames_from_json(const Json& json) try {
  if (json.get<std::string>().empty()) return {};
  return frames_of(read_frames(json.get<std::string>(), {}));
} catch (const Error&) {
  throw LineProblem("has an invalid list of frames");
}

FileRecords records_from_json(const Json& json, int frame) {
  FileRecords files;
  for (const auto& [name, sum] : json.items()) {
    if (frame_of_file(name) != frame)
      throw LineProblem(fmt::format("names {}, which is no file of frame {}", shown(name), frame));
    files[name] = checksum_from_json(sum);
  }
  if (files.empty()) throw LineProblem("names no files");
  return files;
}

void add_frames(const std::vector<int>& more, std::vector<int>& frames) {
  std::vector<int> both;
  std::set_union(frames.begin(), frames.end(), more.begin(), more.end(), std::back_inserter(both));
  frames = std::move(both);
}

/// Returns whether the file describes all frames together, such as the job, the report, or the cameras of a data set.
bool is_document(const std::string& name) {
  static const std::set<std::string_view> documents{"job.toml",
                                                    "report.json",
                                                    "transforms.json",
                                                    "transforms_train.json",
                                                    "transforms_test.json",
                                                    "poses_bounds.npy",
                                                    "test.txt",
                                                    "sparse/0/cameras.txt",
                                                    "sparse/0/images.txt",
                                                    "sparse/0/points3D.txt",
                                                    "sparse/0/test.txt",
                                                    "sparse/0/cameras.bin",
                                                    "sparse/0/images.bin",
                                                    "sparse/0/points3D.bin"};
  return documents.contains(name);
}

void read_written(const Json& json, FolderJournal& journal) {
  const auto name = json.at("written").get<std::string>();
  if (!is_document(name)) throw LineProblem("names a file that no render writes");
  journal.files[name].push_back(checksum_from_json(json));
}

void read_video(const Json& json, FolderJournal& journal) {
  const auto name = json.at("video").get<std::string>();
  if (!is_video_name(name) || name.find('\0') != std::string::npos) throw LineProblem("names a video with an unknown ending");
  const bool is_complete = json.contains("bytes");
  std::vector<int> frames = frames_from_json(json.at("frames"));
  JournalVideo& video = journal.videos[name];
  if (is_complete || video.sums.empty()) video.frames = std::move(frames);
  if (is_complete) video.sums.push_back(checksum_from_json(json));
  if (json.contains("side")) video.side.push_back(checksum_from_json(json["side"]));
}

void read_asked(const Json& json, FolderJournal& journal) {
  add_frames(frames_from_json(json.at("asked")), journal.asked);
  if (!json.contains("companions")) return;
  for (const auto& name : json["companions"].get<std::vector<std::string>>()) {
    if (name != kSingleFolder && name != kPageFolder) throw LineProblem("names a folder that no render writes");
    journal.companions.insert(name);
  }
}

bool is_page_file(const std::string& name) {
  const fs::path path(name);
  return path.is_relative() && path.lexically_normal() == path && path.has_filename() && path.has_parent_path() &&
         *path.begin() == kPageFolder && name.find('\0') == std::string::npos;
}

void read_page(const Json& json, FolderJournal& journal) {
  if (json.at("companion").get<std::string>() != kPageFolder) throw LineProblem("names a folder that no render writes");
  for (const auto& [name, sum] : json.at("files").items()) {
    if (!is_page_file(name)) throw LineProblem(fmt::format("names {}, which is no file of a page", shown(name)));
    journal.page[name] = checksum_from_json(sum);
  }
  journal.companions.insert(kPageFolder);
}

FrameReport report_from_json(const Json& json) {
  const std::optional<FrameReport> report = frame_report_from_json(json);
  if (!report) throw LineProblem("lacks figures of its frame");
  return *report;
}

void read_frame(const Json& json, FolderJournal& journal) {
  const FrameReport report = report_from_json(json);
  journal.frames[report.frame] = {report, records_from_json(json.at("files"), report.frame)};
}

int number_from_json(const Json& json, int most) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > static_cast<std::uint64_t>(most))
    throw LineProblem("has an invalid strip number");
  return json.get<int>();
}

void read_strip(const Json& json, FolderJournal& journal) {
  const FrameReport report = report_from_json(json);
  const int count = number_from_json(json.at("strips"), kMostStrips);
  const int strip = number_from_json(json.at("strip"), count - 1);
  FileRecords files = records_from_json(json.at("files"), report.frame);
  if (files.size() != 1 || files.begin()->first != strip_name(report.frame, strip))
    throw LineProblem("lists files of another strip");
  JournalStrips& strips = journal.strips[report.frame];
  if (!strips.finished.empty() && strips.count != count)
    throw LineProblem("has another number of strips than the lines before it");
  strips.count = count;
  strips.finished[strip] = {report, std::move(files)};
}

void read_strips_of_run(const Json& json, RunReport& run) {
  for (const auto& [frame, strips] : json.items()) {
    const std::vector<int> number = frames_from_json(frame);
    if (number.size() != 1) throw LineProblem("lists strips without their frame");
    run.strips[number.front()] = frames_from_json(strips);
  }
}

void read_run(const Json& json, FolderJournal& journal) {
  RunReport run;
  json.at("host").get_to(run.host);
  if (json.contains("cpu")) json["cpu"].get_to(run.cpu);  // earlier versions did not record the processor
  json.at("unit").get_to(run.unit);
  run.frames = frames_from_json(json.at("frames"));
  if (json.contains("strips")) read_strips_of_run(json["strips"], run);
  json.at("setup_seconds").get_to(run.setup_seconds);
  json.at("write_seconds").get_to(run.write_seconds);
  json.at("peak_memory_bytes").get_to(run.peak_memory_bytes);
  json.at("threads").get_to(run.threads);
  for (const Json& source : json.at("sources")) run.sources.push_back(report_from_json(source));
  journal.runs.push_back(std::move(run));
}

void read_job(const Json& json, FolderJournal& journal) {
  const auto job = json.at("job").get<std::string>();
  if (!journal.job.empty() && journal.job != job) throw LineProblem("names another job than the files before it");
  journal.job = job;
}

/// Throws LineProblem or an exception of nlohmann::json if the line is invalid.
void read_line(const Json& json, bool is_first, FolderJournal& journal) {
  if (!json.is_object()) throw LineProblem("is not a JSON object");
  if (is_first)
    read_job(json, journal);
  else if (json.contains("asked"))
    read_asked(json, journal);
  else if (json.contains("companion"))
    read_page(json, journal);
  else if (json.contains("strip"))
    read_strip(json, journal);
  else if (json.contains("written"))
    read_written(json, journal);
  else if (json.contains("video"))
    read_video(json, journal);
  else if (json.contains("run"))
    read_run(json["run"], journal);
  else
    read_frame(json, journal);
}

// Maximum total size of the journal files. A frame of 48 views takes about 5000 bytes, so the limit is enough for 800,000 such
// frames.
constexpr std::uintmax_t kMaxJournalBytes = std::uintmax_t{4} << 30;

std::string problem_of(const Json& json, bool is_first, FolderJournal& journal) try {
  read_line(json, is_first, journal);
  return {};
} catch (const nlohmann::json::exception&) {
  return "lacks a key, or has one of the wrong type";
} catch (const LineProblem& problem) {
  return problem.what();
}

/// The file of a run that was killed while writing its first line counts as empty.
void read_part(const fs::path& path, std::uintmax_t& bytes_left, FolderJournal& journal) {
  if (!is_regular_file_there(path)) return;  // the file was removed after the folder was listed
  std::istringstream in(read_file_text(path, bytes_left, "the journal of a render"));
  bytes_left -= in.view().size();
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (in.eof() && may_be_cut_line(line)) break;  // the process was killed while writing the line
    const Json json = json_from_text(line);
    const bool is_last = in.eof() || in.peek() == std::ifstream::traits_type::eof();
    // An incomplete last line was cut by a crash of the machine.
    if (json.is_discarded() && is_last && number > 1 && may_be_cut_line(line)) break;
    if (number == 1) journal.parts.push_back(path);
    const std::string wrong = problem_of(json, number == 1, journal);
    if (!wrong.empty() && journal.problem.empty())
      journal.problem = fmt::format("line {} of {} {}", number, shown(path.filename().string()), wrong);
  }
}

/// Returns the job in the first line of a journal file, or an empty string if that line is incomplete.
std::string job_of_part(const fs::path& path) {
  if (!is_regular_file_there(path)) return {};
  std::ifstream in(path, std::ios::binary);
  std::string line;
  std::getline(in, line);
  const Json json = in.eof() ? Json() : json_from_text(line);
  const auto job = json.is_object() ? json.find("job") : json.end();
  return json.is_object() && job != json.end() && job->is_string() ? job->get<std::string>() : std::string();
}

/// Removes claims from `parts` and returns them. A claim is the journal file of a run that finished nothing and whose
/// job differs from the job of the other runs.
std::vector<fs::path> take_claims(std::vector<fs::path>& parts) {
  std::map<std::string, std::vector<fs::path>> by_job;
  for (const fs::path& part : parts)
    if (std::string job = job_of_part(part); !job.empty()) by_job[std::move(job)].push_back(part);
  if (by_job.size() < 2) return {};
  const auto is_claim = [](const fs::path& part) {
    const FolderJournal own = read_journal_part(part);
    return own.problem.empty() && !holds_anything(own);
  };
  std::string job = job_of_part(by_job.begin()->second.front());
  for (const auto& [name, of_job] : by_job)
    if (!std::all_of(of_job.begin(), of_job.end(), is_claim)) job = name;
  std::vector<fs::path> claims;
  for (const auto& [name, of_job] : by_job)
    if (name != job) std::copy_if(of_job.begin(), of_job.end(), std::back_inserter(claims), is_claim);
  std::erase_if(parts, [&](const fs::path& part) { return std::find(claims.begin(), claims.end(), part) != claims.end(); });
  return claims;
}

}  // namespace

bool holds_anything(const FolderJournal& journal) {
  return !journal.frames.empty() || !journal.strips.empty() || !journal.videos.empty();
}

void sync_names(const fs::path& folder, const std::vector<fs::path>& files) {
  std::set<fs::path> folders{folder};
  for (const fs::path& file : files) folders.insert(file.parent_path());
  for (const fs::path& named_in : folders) platform::sync_folder(named_in);
}

FileRecords records_of(const fs::path& folder, const std::vector<fs::path>& files) {
  FileRecords records;
  sync_names(folder, files);
  for (const fs::path& file : files) {
    const std::optional<FileChecksum> sum = file_checksum(file);
    if (!sum) throw Error(file.string(), "cannot be read back to take its checksum");
    records[file.lexically_relative(folder).string()] = *sum;
  }
  return records;
}

Json to_json(const RunReport& run) {
  Json sources = Json::array();
  for (const FrameReport& source : run.sources) sources.push_back(to_json(source));
  Json json{{"host", run.host}, {"cpu", run.cpu}, {"unit", run.unit}, {"frames", write_frames(ranges_of(run.frames))}};
  for (const auto& [frame, strips] : run.strips) json["strips"][std::to_string(frame)] = write_frames(ranges_of(strips));
  json.update({{"setup_seconds", run.setup_seconds},
               {"write_seconds", run.write_seconds},
               {"peak_memory_bytes", run.peak_memory_bytes},
               {"threads", run.threads},
               {"sources", std::move(sources)}});
  return json;
}

fs::path journal_folder(const fs::path& folder) { return folder / ".lippmann"; }

bool is_as_written(const fs::path& file, const std::vector<FileChecksum>& sums) {
  const std::optional<FileChecksum> sum = sums.empty() ? std::nullopt : file_checksum(file);
  return sum && std::find(sums.begin(), sums.end(), *sum) != sums.end();
}

bool is_as_written(const FolderJournal& journal, const fs::path& folder, const std::string& name) {
  const auto found = journal.files.find(name);
  return found != journal.files.end() && is_as_written(folder / name, found->second);
}

bool are_as_recorded(const fs::path& folder, const FileRecords& files) {
  return std::all_of(files.begin(), files.end(),
                     [&](const auto& file) { return file_checksum(folder / file.first) == file.second; });
}

std::optional<FolderJournal> read_journal(const fs::path& folder) {
  const fs::path where = journal_folder(folder);
  std::error_code ignored;
  const fs::file_type type = fs::symlink_status(where, ignored).type();
  if (type == fs::file_type::none || type == fs::file_type::not_found) return std::nullopt;
  if (type != fs::file_type::directory)
    throw Error(where.string(), "is not a folder",
                "the folder of journals that lippmann render makes, or no file of that name");
  std::vector<fs::path> parts;
  for (const fs::directory_entry& entry : entries_of(where))
    if (entry.path().extension() == ".jsonl") parts.push_back(entry.path());
  FolderJournal journal;
  journal.claims = take_claims(parts);
  std::uintmax_t bytes_left = kMaxJournalBytes;
  for (const fs::path& part : parts) read_part(part, bytes_left, journal);
  return journal.parts.empty() && journal.claims.empty() ? std::nullopt : std::optional(std::move(journal));
}

FolderJournal read_journal_part(const fs::path& part) {
  FolderJournal journal;
  std::uintmax_t bytes_left = kMaxJournalBytes;
  read_part(part, bytes_left, journal);
  return journal;
}

void sync_render(const fs::path& folder, const FolderJournal& journal) {
  for (const fs::path& part : journal.parts) platform::sync_file(part);
  std::vector<fs::path> files;
  for (const auto& [frame, record] : journal.frames)
    for (const auto& [name, sum] : record.files) files.push_back(folder / name);
  // One strip is enough, because all strips are in the same folder, and sync_names() syncs folders.
  if (!journal.strips.empty()) files.push_back(folder / strip_name(0, 0));
  sync_names(folder, files);
}

void require_sound(const fs::path& folder, const FolderJournal& journal) {
  if (!journal.problem.empty())
    throw Error(journal_folder(folder).string(), "is damaged, or is not the journal of a render: " + journal.problem,
                "a folder that lippmann render has written to");
}

std::string job_line(const std::string& job) { return line_of({{"job", job}}); }

std::string asked_line(const std::vector<int>& frames, const std::set<std::string>& companions) {
  Json json{{"asked", write_frames(ranges_of(frames))}};
  if (!companions.empty()) json["companions"] = companions;
  return line_of(json);
}

std::string frame_line(const FrameReport& frame, const FileRecords& files) { return line_of(finished_json(frame, files)); }

std::string strip_line(const StripNumber& strip, const FrameReport& report, const FileRecords& files) {
  Json json{{"strip", strip.strip}, {"strips", strip.count}};
  json.update(finished_json(report, files));
  return line_of(json);
}

std::string written_line(const std::string& name, const FileChecksum& sum) {
  Json json{{"written", name}};
  json.update(checksum_json(sum));
  return line_of(json);
}

std::string video_line(const std::string& name, const std::vector<int>& frames, const std::optional<FileChecksum>& sum,
                       const std::optional<FileChecksum>& side) {
  Json json{{"video", name}, {"frames", write_frames(ranges_of(frames))}};
  if (sum) json.update(checksum_json(*sum));
  if (side) json["side"] = checksum_json(*side);
  return line_of(json);
}

std::string page_line(const FileRecords& files) {
  Json json{{"companion", kPageFolder}, {"files", Json::object()}};
  for (const auto& [name, sum] : files) json["files"][name] = checksum_json(sum);
  return line_of(json);
}

std::string side_name(const std::string& video) { return video + ".json"; }

std::string run_line(const RunReport& run) { return line_of({{"run", to_json(run)}}); }

bool is_unfinished(const FolderJournal& journal, const std::string& name) {
  const int frame = frame_of_file(name).value_or(-1);
  const bool may_remain = is_strip_name(name) || !journal.frames.contains(frame);
  return may_remain && std::binary_search(journal.asked.begin(), journal.asked.end(), frame);
}

bool lies_in_folder(const std::string& video) { return fs::path(video).filename() == fs::path(video) && video != ".."; }

}  // namespace lippmann
