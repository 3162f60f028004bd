#include "core/recorded_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "core/file_checksum.hpp"
#include "core/folder_entries.hpp"
#include "core/json_text.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kJournal = ".lippmann";
constexpr std::uintmax_t kMostJournalBytes = std::uintmax_t{4} << 30;  // the same limit as in folder/journal.cpp

struct RenderFile {
  fs::path folder;
  std::string name;
};

std::optional<RenderFile> render_file_of(const fs::path& file) {
  const fs::path whole = fs::absolute(file).lexically_normal(), parent = whole.parent_path();
  if (has_journal(parent)) return RenderFile{parent, whole.filename().string()};
  if (!has_journal(parent.parent_path())) return std::nullopt;
  return RenderFile{parent.parent_path(), (parent.filename() / whole.filename()).string()};
}

void read_lines(const fs::path& part, const std::function<void(std::string_view)>& line) {
  if (!is_regular_file_there(part)) return;
  const std::string text = read_file_text(part, kMostJournalBytes, "the journal of a render");
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view one = std::string_view(text).substr(begin, end - begin);
    const bool is_whole = end < text.size() && one.starts_with('{') && one.ends_with('}');
    const bool is_last = end + 1 >= text.size();
    begin = end + 1;
    if (is_whole)
      line(one);
    else if (!is_last || !may_be_cut_line(one))
      throw Error(part.string(), "is damaged: it has an invalid line",
                  "the journal as it was; a copy of the folder without .lippmann, which is not checked");
  }
}

void read_journal_lines(const fs::path& folder, const std::function<void(std::string_view)>& line) {
  for (const fs::directory_entry& entry : entries_of(folder / kJournal))
    if (entry.path().extension() == ".jsonl") read_lines(entry.path(), line);
}

bool has_more_than_cut_line(const fs::path& part) {
  std::ifstream in(part, std::ios::binary);
  std::string line;
  std::getline(in, line);
  return !in.eof() || !may_be_cut_line(line);
}

std::optional<FileChecksum> checksum_from(const Json& json) {
  const auto bytes = json.is_object() ? json.find("bytes") : json.end();
  if (!json.is_object() || bytes == json.end() || !bytes->is_number_unsigned()) return std::nullopt;
  const auto sum = json.find("xxh3");
  if (sum == json.end() || !sum->is_string()) return std::nullopt;
  return FileChecksum{bytes->get<std::uint64_t>(), sum->get<std::string>()};
}

/// Returns the video's name if `name` is VIDEO.json, the side file of a video. Otherwise returns `name`.
std::string_view video_of(std::string_view name) {
  constexpr std::string_view kSideFile = ".json";
  return name.ends_with(kSideFile) ? name.substr(0, name.size() - kSideFile.size()) : name;
}

std::optional<FileChecksum> recorded_in(std::string_view line, const std::string& name) {
  const std::string_view video = video_of(name);
  if (line.find(video) == std::string_view::npos) return std::nullopt;
  const Json json = json_from_text(line);
  if (!json.is_object()) return std::nullopt;
  if (const auto files = json.find("files"); files != json.end() && files->is_object() && files->contains(name))
    return checksum_from((*files)[name]);
  const auto is_named = [&](const char* key, std::string_view by) { return json.contains(key) && json[key] == by; };
  if (is_named("written", name) || is_named("video", name)) return checksum_from(json);
  const bool is_side_file = video != name && is_named("video", video) && json.contains("side");
  return is_side_file ? checksum_from(json["side"]) : std::nullopt;
}

std::vector<FileChecksum> recorded_sums(const RenderFile& file) {
  std::vector<FileChecksum> sums;
  read_journal_lines(file.folder, [&](std::string_view line) {
    if (auto sum = recorded_in(line, file.name)) sums.push_back(*std::move(sum));
  });
  return sums;
}

std::string ways_out(const fs::path& folder) {
  return fmt::format(
      "the file as it was written, which rendering {} with `resume` makes again; a copy of the folder without .lippmann, which "
      "is not checked",
      (folder / "job.toml").string());
}

void require_sum(const fs::path& file, const std::function<std::optional<FileChecksum>()>& sum) {
  const std::optional<RenderFile> of_render = render_file_of(file);
  if (!of_render) return;
  const std::vector<FileChecksum> sums = recorded_sums(*of_render);
  if (sums.empty()) return;
  const std::optional<FileChecksum> found = sum();
  if (found && std::find(sums.begin(), sums.end(), *found) != sums.end()) return;
  throw Error(file.string(), "is damaged or was replaced: its bytes differ from the bytes that its render wrote",
              ways_out(of_render->folder));
}

}  // namespace

bool has_journal(const fs::path& folder) {
  std::error_code ignored;
  if (fs::symlink_status(folder / kJournal, ignored).type() != fs::file_type::directory) return false;
  const std::vector<fs::directory_entry> parts = entries_of(folder / kJournal);
  return std::any_of(parts.begin(), parts.end(), [](const fs::directory_entry& part) {
    return part.path().extension() == ".jsonl" && is_regular_file_there(part.path()) && has_more_than_cut_line(part.path());
  });
}

std::set<std::string> recorded_names(const fs::path& folder) {
  std::set<std::string> names;
  read_journal_lines(folder, [&](std::string_view line) {
    const Json json = json_from_text(line);
    if (!json.is_object()) return;
    if (const auto files = json.find("files"); files != json.end() && files->is_object())
      for (const auto& [name, sum] : files->items()) names.insert(name);
    if (const auto written = json.find("written"); written != json.end() && written->is_string()) names.insert(*written);
  });
  return names;
}

bool may_be_cut_line(std::string_view line) {
  if (line.find('\0') == std::string_view::npos && !line.starts_with('{')) return line.empty();
  return std::all_of(line.begin(), line.end(),
                     [](char c) { return c == '\0' || (static_cast<unsigned char>(c) >= 0x20 && c != '\x7f'); });
}

void require_as_recorded(const fs::path& file, std::span<const std::byte> bytes) {
  require_sum(file, [&] { return checksum_of(bytes); });
}

std::string read_recorded_text(const fs::path& path, std::uintmax_t limit_bytes, const std::string& accepted) {
  std::string text = read_file_text(path, limit_bytes, accepted);
  require_as_recorded(path, std::as_bytes(std::span(text)));
  return text;
}

std::vector<std::byte> read_recorded_bytes(const fs::path& path, std::uintmax_t limit_bytes, const std::string& accepted) {
  std::vector<std::byte> bytes = read_file_bytes(path, limit_bytes, accepted);
  require_as_recorded(path, bytes);
  return bytes;
}

void require_as_recorded(const fs::path& file) {
  require_sum(file, [&] { return file_checksum(file); });
}

void require_recorded_frames(const fs::path& folder) {
  if (!has_journal(folder)) return;
  read_journal_lines(folder, [&](std::string_view line) {
    if (!line.starts_with("{\"frame\"")) return;
    const Json json = json_from_text(line);
    const auto files = json.is_object() ? json.find("files") : json.end();
    if (!json.is_object() || files == json.end() || !files->is_object()) return;
    for (const auto& [name, sum] : files->items()) {
      std::error_code ignored;
      if (!fs::exists(fs::symlink_status(folder / name, ignored)))
        throw Error((folder / name).string(), "is missing: the render in this folder wrote it", ways_out(folder));
    }
  });
}

}  // namespace lippmann
