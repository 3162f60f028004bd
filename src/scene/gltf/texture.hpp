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

/// Collects the textures that materials use, and decodes all of them at the end. An image is decoded once for each combination
/// of wrap modes and encoding.
class TextureReader {
 public:
  TextureReader(Document& document, Scene& scene)
      : document_(document), scene_(scene), pending_({document.limits.texture_side, document.texture_bytes}) {}

  /// Returns the index in scene.textures of a texture of the file. decode() sets its texels. If the texture has no supported
  /// image, warns and returns -1. `srgb` is true for colours and false for data.
  int read(int texture, bool srgb);

  /// Returns a texture whose channel G is the roughness 1 - `glossiness` * a, with a the value of channel A of the file's
  /// texture.
  int read_roughness(int texture, float glossiness);

  /// Decodes all textures that have been read.
  void decode();

 private:
  /// Returns why an image cannot be decoded, or an empty text if it can.
  const std::string& problem_of(int image);

  Document& document_;
  Scene& scene_;
  PendingTextures pending_;
  std::map<int, std::string> problems_;  ///< result of problem_of() for each image
  std::map<std::tuple<int, Wrap, Wrap, bool>, int> known_;
  /// Maps a texture of the Scene and a glossiness factor to the roughness texture made from both.
  std::map<std::pair<int, float>, int> roughness_;
};

}  // namespace lippmann::gltf
