// Decodes the textures that glTF materials use.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/document.hpp"
#include "scene/pending_textures.hpp"

namespace lippmann::gltf {

/// Collects the textures in use and decodes all of them at the end. An image is decoded once per combination of wrap modes and
/// encoding.
class TextureReader {
 public:
  TextureReader(Document& document, Scene& scene)
      : document_(document), scene_(scene), pending_({document.limits.texture_side, document.texture_bytes}) {}

  /// Returns the index in scene.textures of a texture of the file; its texels follow in decode(). Returns -1, with a warning,
  /// if it has no supported image. srgb: true for colours, false for data.
  int read(int texture, bool srgb);

  /// Returns a texture whose G is the roughness 1 - factor * glossiness, where glossiness is the alpha of the file's texture.
  int read_roughness(int texture, float glossiness);

  /// Decodes the texels of all textures read so far.
  void decode();

 private:
  /// Returns why an image cannot be read; empty: it can.
  const std::string& problem_of(int image);

  Document& document_;
  Scene& scene_;
  PendingTextures pending_;
  std::map<int, std::string> problems_;  ///< results of problem_of() by image
  std::map<std::tuple<int, Wrap, Wrap, bool>, int> known_;
  std::map<std::pair<int, float>, int> roughness_;  ///< by texture index in the Scene and glossiness factor
};

}  // namespace lippmann::gltf
