// Decodes the textures of a glTF file that materials use.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/pending_textures.hpp"

namespace lippmann::gltf {

/// Decodes each image once for each way to use it (wrap modes, sRGB or data), all together when all are known.
class TextureReader {
 public:
  TextureReader(Document& document, Scene& scene)
      : document_(document), scene_(scene), pending_({document.limits.texture_side, document.texture_bytes}) {}

  /// The index in scene.textures of a texture of the file, which has no texels yet. -1, with a warning, where it has no image
  /// that is supported. srgb: its colours are encoded; false for data.
  int read(int texture, bool srgb);

  /// The same of a texture whose alpha is glossiness, as data whose G is the roughness 1 - factor * glossiness.
  int read_roughness(int texture, float glossiness);

  /// Gives the textures that were read their texels.
  void decode();

 private:
  /// Why an image of the file cannot be read; empty: nothing speaks against it.
  const std::string& problem_of(int image);

  Document& document_;
  Scene& scene_;
  PendingTextures pending_;
  std::map<int, std::string> problems_;  ///< by image
  std::map<std::tuple<int, Wrap, Wrap, bool>, int> known_;
  std::map<std::pair<int, float>, int> roughness_;  ///< by texture of the scene and factor
};

}  // namespace lippmann::gltf
