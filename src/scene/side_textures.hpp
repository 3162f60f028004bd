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
  /// `folders` may contain the images. `texture_bytes` is as in LoadOptions. Textures are added to `scene`. `scene` and
  /// `context` must outlive this object.
  SideTextures(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context);

  /// Returns the index of the texture whose image the scene file calls `name` at `where`. If the image cannot be used, warns
  /// and returns -1.
  int add(const std::string& name, const std::string& where);

  void decode();

 private:
  SideFolders folders_;
  Scene& scene_;
  const Context& context_;
  std::map<std::string, int, std::less<>> known_;
  PendingTextures pending_;
};

}  // namespace lippmann
