#include "view/preview.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "image/webp.hpp"

namespace lippmann {
namespace {

/// Approximate number of pixels of a preview. Quilts with less than four times this number have no preview.
constexpr double kPreviewPixels = 512.0 * 512.0;
constexpr int kPreviewQuality = 60;

void write_mean(const Image8& quilt, Vec2i first, Vec2i last, unsigned char* out) {
  unsigned sum[3]{};
  for (int y = first.y; y < last.y; ++y)
    for (int x = first.x; x < last.x; ++x)
      for (int channel = 0; channel < 3; ++channel)
        sum[channel] += quilt.rgb[3 * (static_cast<std::size_t>(y) * quilt.width + x) + channel];
  const auto count = static_cast<unsigned>((last.x - first.x) * (last.y - first.y));
  for (int channel = 0; channel < 3; ++channel) out[channel] = static_cast<unsigned char>((sum[channel] + count / 2) / count);
}

int block_start(int block, int blocks, int pixels) { return static_cast<int>(static_cast<long long>(block) * pixels / blocks); }

}  // namespace

std::optional<Vec2i> preview_view_size(const PageFacts& facts) {
  const double pixels = double(facts.tiles.columns) * facts.tiles.rows * facts.view_size.x * facts.view_size.y;
  if (pixels < 4.0 * kPreviewPixels) return std::nullopt;
  const double by = std::sqrt(pixels / kPreviewPixels);
  const auto smaller = [&](int side) { return std::max(1, static_cast<int>(side / by)); };
  return Vec2i(smaller(facts.view_size.x), smaller(facts.view_size.y));
}

Image8 preview_of(const Image8& quilt, const PageFacts& facts) {
  const Vec2i size = preview_view_size(facts).value();
  const Vec2i whole(size.x * facts.tiles.columns, size.y * facts.tiles.rows);
  Image8 small{whole.x, whole.y, std::vector<unsigned char>(std::size_t{3} * whole.x * whole.y)};
  for (int y = 0; y < whole.y; ++y)
    for (int x = 0; x < whole.x; ++x) {
      const Vec2i tile(x / size.x * facts.view_size.x, y / size.y * facts.view_size.y);
      const Vec2i first(block_start(x % size.x, size.x, facts.view_size.x), block_start(y % size.y, size.y, facts.view_size.y));
      const Vec2i last(block_start(x % size.x + 1, size.x, facts.view_size.x),
                       block_start(y % size.y + 1, size.y, facts.view_size.y));
      write_mean(quilt, tile + first, tile + last, &small.rgb[3 * (static_cast<std::size_t>(y) * whole.x + x)]);
    }
  return small;
}

std::string encoded_preview(const Image8& quilt, const PageFacts& facts) {
  const std::vector<std::byte> bytes = encode_lossy_webp(preview_of(quilt, facts), kPreviewQuality);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace lippmann
