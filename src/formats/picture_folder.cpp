#include "formats/picture_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <utility>

#include "core/folder_entries.hpp"
#include "core/printable.hpp"
#include "formats/frame_names.hpp"
#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct FolderContent {
  std::vector<fs::path> pictures;
  std::vector<std::string> others;  ///< names of folders end in '/'
};

FolderContent content_of(const fs::path& folder) {
  FolderContent content;
  for (const fs::directory_entry& entry : entries_of(folder, "a folder of pictures")) {
    std::error_code ignored;
    const std::string name = entry.path().filename().string();
    if (entry.is_directory(ignored))
      content.others.push_back(name + "/");
    else if (is_picture_name(entry.path()))
      content.pictures.push_back(entry.path());
    else
      content.others.push_back(name);
  }
  return content;
}

bool is_ignorable(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  if (lower.ends_with('/') || lower == "thumbs.db" || lower == "desktop.ini") return true;
  constexpr std::string_view kNotes[] = {".txt", ".md", ".pdf", ".xmp"};
  return std::any_of(std::begin(kNotes), std::end(kNotes), [&](std::string_view ending) { return lower.ends_with(ending); });
}

void require_two(const fs::path& folder, const FolderContent& content) {
  if (content.pictures.size() >= 2) return;
  const std::string accepted = "view_000.png, view_001.png, ..., or two or more pictures of one size with any names";
  if (content.pictures.size() == 1)
    throw Error(folder.string(), "contains only one picture, " + content.pictures.front().filename().string(), accepted);
  throw Error(folder.string(), "contains no views" + (content.others.empty() ? "" : ", only " + listed_names(content.others)),
              accepted);
}

void require_distinct_stems(const fs::path& folder, const std::vector<fs::path>& pictures) {
  std::map<std::string, fs::path> by_stem;
  for (const fs::path& picture : pictures) {
    const auto [first, is_new] = by_stem.emplace(picture.stem().string(), picture.filename());
    if (!is_new)
      throw Error(
          folder.string(),
          fmt::format("has two pictures with the same name: {} and {}", first->second.string(), picture.filename().string()),
          "one picture for each view");
  }
}

const char* kind_text(SampleKind kind) {
  switch (kind) {
    case SampleKind::kByte:
      return "8-bit";
    case SampleKind::kWord:
      return "16-bit";
    case SampleKind::kFloat:
      break;
  }
  return "float";
}

std::string shape_text(const PictureShape& shape) {
  return fmt::format("{}x{} {}", shape.width, shape.height, kind_text(shape.kind));
}

void require_one_shape(const fs::path& folder, const std::vector<fs::path>& pictures) {
  std::vector<std::string> shapes;
  std::map<std::string, int> counts;
  for (const fs::path& picture : pictures) ++counts[shapes.emplace_back(shape_text(picture_shape(picture)))];
  if (counts.size() == 1) return;
  const std::string usual =
      std::max_element(shapes.begin(), shapes.end(), [&](const auto& a, const auto& b) { return counts[a] < counts[b]; })[0];
  std::vector<std::string> others;
  for (std::size_t i = 0; i < pictures.size(); ++i)
    if (shapes[i] != usual) others.push_back(fmt::format("{}: {}", printable(pictures[i].filename().string()), shapes[i]));
  throw Error(folder.string(),
              fmt::format("{} of its {} pictures are {}, but others differ: {}", pictures.size() - others.size(),
                          pictures.size(), usual, listed_names(others)),
              "pictures of one size and one kind of samples");
}

}  // namespace

std::string listed_names(const std::vector<std::string>& names) {
  constexpr std::size_t kListedNames = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kListedNames); ++i) list += (i == 0 ? "" : ", ") + printable(names[i]);
  if (names.size() > kListedNames) list += fmt::format(" and {} more", names.size() - kListedNames);
  return list;
}

bool is_picture_folder(const fs::path& folder) {
  const FolderContent content = content_of(folder);
  return content.pictures.size() >= 2 && std::all_of(content.others.begin(), content.others.end(), is_ignorable);
}

std::vector<fs::path> pictures_of_views(const fs::path& folder, const std::function<void(std::string_view)>& warn) {
  FolderContent content = content_of(folder);
  require_two(folder, content);
  require_distinct_stems(folder, content.pictures);
  require_one_shape(folder, content.pictures);
  if (warn && !content.others.empty())
    warn(fmt::format("{}: its {} pictures are the views, in the order of their names from {} to {}; left out: {}.",
                     folder.string(), content.pictures.size(), printable(content.pictures.front().filename().string()),
                     printable(content.pictures.back().filename().string()), listed_names(content.others)));
  return std::move(content.pictures);
}

bool warn_of_pictures_without_camera(const fs::path& folder, const std::function<bool(const fs::path&)>& has_camera,
                                     std::string_view file, const std::function<void(std::string_view)>& warn) {
  std::vector<std::string> names;
  for (const fs::path& picture : content_of(folder).pictures)
    if (!has_camera(picture)) names.push_back(picture.filename().string());
  if (!names.empty() && warn)
    warn(fmt::format("{}: {} without a camera in {} left out: {}", folder.string(),
                     names.size() == 1 ? "a picture" : fmt::format("{} pictures", names.size()),
                     fmt::format("{} {}", file, names.size() == 1 ? "is" : "are"), listed_names(names)));
  return !names.empty();
}

}  // namespace lippmann
