// Collects the textures of a scene file with the sizes of their images, and decodes all of them at the end, reduced to fit into
// memory (texture_budget.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "image/decode.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/texture_budget.hpp"

namespace lippmann {

/// Limits for textures.
struct TextureLimits {
  int longest_side = 16384;                           ///< longest side of an image, in texels
  std::uint64_t bytes = LoadOptions{}.texture_bytes;  ///< limit for all textures together, and for each image before reduction
};

class PendingTextures {
 public:
  /// Returns the encoded bytes of an image, and may keep them in `storage`. Called by add(), and by decode() from any thread.
  using Picture = std::function<FileBytes(std::vector<std::byte>& storage)>;
  /// Modifies a decoded texture.
  using Change = std::function<void(Texture&)>;

  explicit PendingTextures(const TextureLimits& limits) : limits_(limits) {}

  /// Appends a texture with the width and height of its image but no texels, and returns its index in `textures`. Throws Error
  /// at `where` for unsupported or too large images.
  int add(Texture described, std::string where, Picture picture, std::vector<Texture>& textures, Change change = {});

  /// Adds another texture with the picture of texture `of`, which must have been added before, and with another `change`.
  /// Returns its index.
  int add_changed(int of, Change change, std::vector<Texture>& textures);

  /// Decodes all textures. Uses few of the context's threads, because decoding takes several times the memory of the texels. If
  /// the textures exceed the limit, halves the largest ones and calls `warn`. Throws Error for corrupt images.
  void decode(std::vector<Texture>& textures, const Context& context, const std::function<void(const std::string&)>& warn);

 private:
  struct Entry {
    std::size_t texture;
    std::string where;
    Picture picture;
    Change change;
  };
  std::vector<TextureExtent> extents(const std::vector<Texture>& textures) const;

  TextureLimits limits_;
  std::vector<Entry> entries_;
};

}  // namespace lippmann
