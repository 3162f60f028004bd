// Loads the textures of scene files that refer to image files (OBJ materials, PLY).
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
  /// folders: those that may contain the images. texture_bytes: as in LoadOptions. Adds textures to the scene. `scene` and
  /// `context` must outlive this object.
  SideTextures(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context);

  /// Returns the index of the texture that a statement at `where` refers to as `name`; -1, with a warning, if the image cannot
  /// be used.
  int add(const std::string& name, const std::string& where);

  /// Decodes the texels of all textures.
  void decode();

 private:
  SideFolders folders_;
  Scene& scene_;
  const Context& context_;
  std::map<std::string, int, std::less<>> known_;  ///< by name; -1: unusable
  PendingTextures pending_;
};

}  // namespace lippmann
