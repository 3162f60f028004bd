// Collects the textures of a scene file. decode() decodes them when all sizes are known, so that they can be reduced to fit
// into memory.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "image/decode.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/texture_budget.hpp"

namespace lippmann {

struct TextureLimits {
  int longest_side = 16384;
  /// Limit for the decoded size of all textures together, and of each image before reduction.
  std::uint64_t bytes = LoadOptions{}.texture_bytes;
};

class PendingTextures {
 public:
  /// Returns the encoded bytes of an image, which may be kept in `storage`. decode() calls this function from several threads.
  using Picture = std::function<FileBytes(std::vector<std::byte>& storage)>;
  using Change = std::function<void(Texture&)>;

  explicit PendingTextures(const TextureLimits& limits) : limits_(limits) {}

  /// Appends a texture with the width and height of its image but no texels. Returns its index in `textures`. Throws Error at
  /// `where` if the image is unsupported or too large.
  int add(Texture described, std::string where, Picture picture, std::vector<Texture>& textures, Change change = {});

  int add_changed(int of, Change change, std::vector<Texture>& textures);

  /// Decodes all textures, on only a few threads, because decoding needs several times the memory of the texels. If the
  /// textures exceed the limit, halves the largest ones and calls `warn`. Throws Error for corrupt images.
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
