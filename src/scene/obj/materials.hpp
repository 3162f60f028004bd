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
  /// `folders` are the folders that may contain material files and images. `texture_bytes` is as in LoadOptions. Materials and
  /// textures are added to `scene`.
  Materials(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context);

  /// Reads all .mtl files that an mtllib statement at `where` names. Warns about files that cannot be used.
  void read_library(std::string_view names, const std::string& where);

  /// Returns the index of the material called `name`. For unknown names, warns and returns a grey material. For an empty name,
  /// returns the grey material without a warning.
  int find(std::string_view name, const std::string& where);

  void decode_textures() { textures_.decode(); }

 private:
  void read_file(const std::string& name, const std::string& where);
  bool exists(std::string_view name, const std::string& where) const;

  SideFolders folders_;
  SideTextures textures_;
  Scene& scene_;
  const Context& context_;
  std::map<std::string, int, std::less<>> known_;  ///< material index by name
  std::set<std::string> read_;                     ///< names of the .mtl files read so far
  std::size_t text_left_;                          ///< maximum total size in bytes of the .mtl files still to be read
};

}  // namespace lippmann::obj
