#include "scene/tachyon/scene_folder.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "core/file_content.hpp"
#include "lippmann/core/error.hpp"
#include "scene/text_file.hpp"

namespace lippmann::tachyon {

namespace fs = std::filesystem;

SceneFolder::SceneFolder(const fs::path& scene_file, const fs::path& asset_root)
    : folders_{scene_file.parent_path(), asset_root} {}

SideFile SceneFolder::find(std::string_view name, const std::string& where) const {
  return find_side_file(folders_, name, where);
}

fs::path SceneFolder::resolve(std::string_view name, const std::string& where) const {
  return side_file(folders_, name, where);
}

std::string SceneFolder::read_text(const fs::path& file, const std::string& where) {
  std::string text = read_text_file(file, where, budget_bytes_, "at most 1 GiB of text, included files counted");
  budget_bytes_ -= text.size();
  const auto stand_in = stand_in_for_file(std::as_bytes(std::span(text)));
  if (stand_in && text.find_first_not_of(" \t\r\n") != text.npos)
    throw Error(where, fmt::format("{} is {}", file.string(), stand_in->what), stand_in->advice);
  return utf8_text(std::move(text));
}

}  // namespace lippmann::tachyon
