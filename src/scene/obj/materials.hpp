// The materials of an OBJ file, from its .mtl files.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/side_file.hpp"
#include "scene/side_textures.hpp"

namespace lippmann::obj {

class Materials {
 public:
  /// folders: where files may lie. texture_bytes: as LoadOptions has it. Materials and textures go to the scene.
  Materials(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context);

  /// Reads what an mtllib statement at `where` names: a file, or several. Files that cannot be used are a warning.
  void read_library(std::string_view names, const std::string& where);

  /// The index of a material; of one that no library has, with a warning, a grey one. Empty: grey.
  int find(std::string_view name, const std::string& where);

  /// Gives the textures of all libraries their texels.
  void decode_textures() { textures_.decode(); }

 private:
  void read_file(const std::string& name, const std::string& where);
  bool exists(std::string_view name, const std::string& where) const;

  SideFolders folders_;
  SideTextures textures_;
  Scene& scene_;
  const Context& context_;
  std::map<std::string, int, std::less<>> known_;  ///< materials by name
  std::set<std::string> read_;                     ///< libraries
  std::size_t text_left_;                          ///< bytes of libraries
};

}  // namespace lippmann::obj
