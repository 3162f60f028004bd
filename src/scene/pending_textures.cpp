#include "scene/pending_textures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lippmann/core/parallel.hpp"
#include "scene/texture_image.hpp"

namespace lippmann {
namespace {

/// Returns a message about the number of reduced textures, or an empty text if none was reduced.
std::string describe_halved(const std::vector<int>& halvings, std::uint64_t bytes) {
  const auto count = std::count_if(halvings.begin(), halvings.end(), [](int n) { return n > 0; });
  if (count == 0) return {};
  const int most = *std::max_element(halvings.begin(), halvings.end());
  return fmt::format("{} of {} textures are reduced to {} of their resolution to fit into {} MB (texture-memory)", count,
                     halvings.size(), most == 1 ? "half" : fmt::format("1/2 to 1/{}", 1 << most), bytes >> 20);
}

/// Images are decoded at full size before they are reduced, so all images in progress must fit into `bytes`.
int decoded_at_once(const std::vector<TextureExtent>& extents, std::uint64_t bytes) {
  constexpr std::uint64_t kMost = 4;
  std::uint64_t largest = 1;
  for (const TextureExtent& extent : extents)
    largest = std::max(largest, 4 * static_cast<std::uint64_t>(extent.size.x) * static_cast<std::uint64_t>(extent.size.y));
  return static_cast<int>(std::clamp<std::uint64_t>(bytes / largest, 1, kMost));
}

}  // namespace

int PendingTextures::add(Texture described, std::string where, Picture picture, std::vector<Texture>& textures, Change change) {
  std::vector<std::byte> storage;
  const Vec2i size = texture_size(picture(storage), where);
  if (std::max(size.x, size.y) > limits_.longest_side)
    throw Error(where, fmt::format("has {} x {} pixels", size.x, size.y),
                fmt::format("1 to {} pixels per side", limits_.longest_side));
  if (4 * static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) > limits_.bytes)
    throw Error(where, fmt::format("has {} x {} pixels, which take too much memory", size.x, size.y),
                fmt::format("at most {} MB at 4 bytes per pixel (texture-memory)", limits_.bytes >> 20));
  described.width = size.x, described.height = size.y;
  entries_.push_back({textures.size(), std::move(where), std::move(picture), std::move(change)});
  textures.push_back(std::move(described));
  return static_cast<int>(entries_.back().texture);
}

int PendingTextures::add_changed(int of, Change change, std::vector<Texture>& textures) {
  const auto same = std::find_if(entries_.begin(), entries_.end(),
                                 [&](const Entry& entry) { return entry.texture == static_cast<std::size_t>(of); });
  entries_.push_back({textures.size(), same->where, same->picture, std::move(change)});
  textures.push_back(textures[static_cast<std::size_t>(of)]);
  return static_cast<int>(entries_.back().texture);
}

std::vector<TextureExtent> PendingTextures::extents(const std::vector<Texture>& textures) const {
  std::vector<TextureExtent> extents;
  for (const Entry& entry : entries_) {
    const Texture& texture = textures[entry.texture];
    extents.push_back({{texture.width, texture.height}, !texture.srgb});
  }
  return extents;
}

void PendingTextures::decode(std::vector<Texture>& textures, const Context& context,
                             const std::function<void(const std::string&)>& warn) {
  const std::vector<int> halvings = halvings_within(limits_.bytes, extents(textures));
  if (const std::string halved = describe_halved(halvings, limits_.bytes); !halved.empty()) warn(halved);
  const ThreadPool pool(std::min(resolved_threads(context), decoded_at_once(extents(textures), limits_.bytes)));
  pool.for_each(entries_.size(), [&](std::size_t i) {
    if (context.cancelled) return;
    const Entry& entry = entries_[i];
    Texture& texture = textures[entry.texture];
    std::vector<std::byte> storage;
    decode_texture(entry.picture(storage), entry.where, texture);
    if (entry.change) entry.change(texture);
    for (int n = 0; n < halvings[i]; ++n) halve(texture);
  });
  entries_.clear();
}

}  // namespace lippmann
