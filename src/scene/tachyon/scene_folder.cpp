#include "scene/tachyon/scene_folder.hpp"

#include "scene/side_file.hpp"
#include "scene/text_file.hpp"

namespace lippmann::tachyon {

namespace fs = std::filesystem;

SceneFolder::SceneFolder(const fs::path& scene_file)
    : folder_(scene_file.has_parent_path() ? scene_file.parent_path() : fs::path(".")) {}

fs::path SceneFolder::resolve(std::string_view name, const std::string& where) const { return side_file(folder_, name, where); }

std::string SceneFolder::read_text(const fs::path& file, const std::string& where) {
  std::string text = read_text_file(file, where, budget_bytes_, "at most 1 GiB of text, included files counted");
  budget_bytes_ -= text.size();
  return text;
}

}  // namespace lippmann::tachyon
