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
  /// `folders` may contain material files and images. `texture_bytes` is as in LoadOptions. Materials and textures are added to
  /// `scene`.
  Materials(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context);

  void read_library(std::string_view names, const std::string& where);

  /// Returns the index of the material called `name`. For unknown names, warns and returns a grey material. For an empty name,
  /// returns it without a warning.
  int find(std::string_view name, const std::string& where);

  void decode_textures() { textures_.decode(); }

 private:
  void read_file(const std::string& name, const std::string& where);
  bool exists(std::string_view name, const std::string& where) const;

  SideFolders folders_;
  SideTextures textures_;
  Scene& scene_;
  const Context& context_;
  std::map<std::string, int, std::less<>> known_;
  std::set<std::string> read_;
  std::size_t text_left_;  ///< maximum total size in bytes of the .mtl files still to be read
};

}  // namespace lippmann::obj
