// Reads the materials of an OBJ file from its .mtl files.
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
  /// `folders`: those that may contain the material files and images. texture_bytes: as in LoadOptions. Adds materials and
  /// textures to the scene.
  Materials(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context);

  /// Reads all files that an mtllib statement at `where` names. Warns about files that cannot be used.
  void read_library(std::string_view names, const std::string& where);

  /// Returns the index of a material. Unknown materials are grey, with a warning; an empty name means grey.
  int find(std::string_view name, const std::string& where);

  /// Decodes the textures of all libraries.
  void decode_textures() { textures_.decode(); }

 private:
  void read_file(const std::string& name, const std::string& where);
  bool exists(std::string_view name, const std::string& where) const;

  SideFolders folders_;
  SideTextures textures_;
  Scene& scene_;
  const Context& context_;
  std::map<std::string, int, std::less<>> known_;  ///< material indices by name
  std::set<std::string> read_;                     ///< names of libraries read so far
  std::size_t text_left_;                          ///< total bytes that further libraries may have
};

}  // namespace lippmann::obj
