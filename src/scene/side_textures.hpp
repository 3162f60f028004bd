// The textures of scene files that name pictures beside them (OBJ's materials, PLY): found, checked, and decoded together.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/pending_textures.hpp"
#include "scene/side_file.hpp"

namespace lippmann {

class SideTextures {
 public:
  /// folders: where pictures may lie. texture_bytes: as LoadOptions has it. Textures go to the scene. `scene` and `context`
  /// must outlive this object.
  SideTextures(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context);

  /// The index of the texture that a statement at `where` calls `name`; -1, with a warning, if the picture cannot be used.
  int add(const std::string& name, const std::string& where);

  /// Gives all textures their texels.
  void decode();

 private:
  SideFolders folders_;
  Scene& scene_;
  const Context& context_;
  std::map<std::string, int, std::less<>> known_;  ///< by name; -1: cannot be shown
  PendingTextures pending_;
};

}  // namespace lippmann
