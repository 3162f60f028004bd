#include "reuse/patches.hpp"

#include <algorithm>
#include <cmath>

#include "trace/strip_order.hpp"

namespace lippmann {

Patches::Patches(const Optics& optics, RayOrder order) : begin_{0} {
  const StripOrder strip = make_strip_order(optics, order);
  const int width = film_size(optics).x, height = film_size(optics).y;
  per_strip_ = (strip.pixels.size() + kPatchPixels - 1) / kPatchPixels;
  pixels_.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int top = 0; top < height; top += strip.strip_height)
    for (std::size_t i = 0; i < strip.pixels.size(); ++i) {
      const StripPixel& pixel = strip.pixels[i];
      const bool ends_patch = (i + 1) % kPatchPixels == 0 || i + 1 == strip.pixels.size();
      if (top + pixel.y < height) pixels_.push_back(static_cast<std::uint32_t>((top + pixel.y) * width + pixel.x));
      if (ends_patch) begin_.push_back(pixels_.size());
    }
}

void Patches::root_mean_squares(std::span<const std::uint8_t> of_pixels, const ThreadPool& pool,
                                std::vector<std::uint8_t>& of_patches) const {
  constexpr std::size_t kPiece = 512;
  of_patches.resize(count());
  pool.for_each((count() + kPiece - 1) / kPiece, [&](std::size_t piece) {
    for (std::size_t patch = piece * kPiece; patch < std::min(count(), (piece + 1) * kPiece); ++patch) {
      std::uint32_t sum = 0;
      for (const std::uint32_t p : pixels(patch)) sum += std::uint32_t{of_pixels[p]} * of_pixels[p];
      const float mean = static_cast<float>(sum) / static_cast<float>(std::max<std::size_t>(1, pixels(patch).size()));
      of_patches[patch] = static_cast<std::uint8_t>(std::lround(std::sqrt(mean)));
    }
  });
}

std::vector<float> Patches::costs(std::span<const std::uint32_t> rays_of_blocks) const {
  const std::size_t blocks_per_strip = (per_strip_ + kPacketsPerBlock - 1) / kPacketsPerBlock;
  std::vector<float> costs(count());
  double sum = 0.0;
  for (std::size_t patch = 0; patch < count(); ++patch) {
    const std::size_t strip = patch / per_strip_, in_strip = patch % per_strip_, block = in_strip / kPacketsPerBlock;
    const std::size_t patches = std::min<std::size_t>(kPacketsPerBlock, per_strip_ - block * kPacketsPerBlock);
    const std::uint32_t rays = rays_of_blocks[strip * blocks_per_strip + block];
    costs[patch] = static_cast<float>(rays) / static_cast<float>(patches);
    sum += costs[patch];
  }
  const auto per_mean = static_cast<float>(static_cast<double>(count()) / sum);
  for (float& cost : costs) cost *= per_mean;
  return costs;
}

}  // namespace lippmann
