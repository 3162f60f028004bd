#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/pending_textures.hpp"

namespace lippmann::gltf {

/// Collects the textures that materials use, and decodes all of them at the end, once for each combination of wrap modes and
/// encoding.
class TextureReader {
 public:
  TextureReader(Document& document, Scene& scene)
      : document_(document), scene_(scene), pending_({document.limits.texture_side, document.texture_bytes}) {}

  /// Returns the index in scene.textures of a texture of the file. decode() sets its texels. If the texture has no supported
  /// image, warns and returns -1. `srgb` is true for colours and false for data.
  int read(int texture, bool srgb);

  /// Returns a texture whose channel G is the roughness 1 - `glossiness` * a, where a is channel A of the file's texture.
  int read_roughness(int texture, float glossiness);

  void decode();

 private:
  const std::string& problem_of(int image);

  Document& document_;
  Scene& scene_;
  PendingTextures pending_;
  std::map<int, std::string> problems_;
  std::map<std::tuple<int, Wrap, Wrap, bool>, int> known_;
  std::map<std::pair<int, float>, int> roughness_;
};

}  // namespace lippmann::gltf
