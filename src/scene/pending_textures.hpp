// The textures of a scene file that is being read: remembered with the sizes of their pictures, and decoded together once all
// are known, so that they fit into memory (texture_budget.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "image/decode.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/texture_budget.hpp"

namespace lippmann {

/// What textures may be.
struct TextureLimits {
  int longest_side = 16384;                           ///< texels of a picture
  std::uint64_t bytes = LoadOptions{}.texture_bytes;  ///< limit for all textures together, and for one unhalved picture
};

class PendingTextures {
 public:
  /// The bytes of a picture's file, which may be put into `storage`. Called twice, from any thread; lives until decode().
  using Picture = std::function<FileBytes(std::vector<std::byte>& storage)>;
  /// What is made of the decoded texture.
  using Change = std::function<void(Texture&)>;

  explicit PendingTextures(const TextureLimits& limits) : limits_(limits) {}

  /// Appends a texture with the width and height of its picture and without texels, and returns its index in `textures`. Throws
  /// Error at `where` for what is no such picture or is too large.
  int add(Texture described, std::string where, Picture picture, std::vector<Texture>& textures, Change change = {});

  /// Another of a texture that was added, changed.
  int add_changed(int of, Change change, std::vector<Texture>& textures);

  /// Gives all of them their texels, on a few of the context's threads: a picture takes several times its texels while it is
  /// decoded. Where they are too many the largest textures are halved, and `warn` is told so. Throws Error for damaged
  /// pictures.
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
