#include "scene/texture_budget.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>

namespace lippmann {
namespace {

std::uint64_t texels(Vec2i size) { return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y); }

class Curve {
 public:
  explicit Curve(bool srgb) : codes_(65536) {
    for (std::size_t i = 0; i < 256; ++i) {
      const double s = static_cast<double>(i) / 255.0;
      const double linear = !srgb ? s : s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
      linear_[i] = static_cast<std::uint32_t>(linear * 65535.0 + 0.5);
    }
    for (std::size_t i = 0; i < codes_.size(); ++i) {
      const double linear = static_cast<double>(i) / 65535.0;
      const double s = !srgb ? linear : linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
      codes_[i] = static_cast<std::uint8_t>(s * 255.0 + 0.5);
    }
  }

  std::uint32_t linear(std::uint8_t code) const { return linear_[code]; }
  std::uint8_t code(std::uint32_t linear) const { return codes_[linear]; }

 private:
  std::array<std::uint32_t, 256> linear_{};
  std::vector<std::uint8_t> codes_;
};

/// The range of fine texels, along one axis, that a coarse texel averages: two, or three at the end of an odd side.
struct Covered {
  int begin, end;
};
Covered covered(int coarse_texel, int coarse, int fine) {
  const int begin = 2 * coarse_texel;
  return {begin, coarse_texel + 1 < coarse ? begin + 2 : fine};
}

/// Adds the linear values of a row of fine texels to the sums of the coarse texels that cover them.
void add_row(const Texture& fine, int row, int coarse, const Curve& color, const Curve& alpha,
             std::vector<std::uint32_t>& sums) {
  const std::size_t width = static_cast<std::size_t>(fine.width);
  const std::uint8_t* texel = &fine.rgba[4 * static_cast<std::size_t>(row) * width];
  for (int x = 0; x < coarse; ++x) {
    std::uint32_t* const sum = &sums[4 * static_cast<std::size_t>(x)];
    const auto [begin, end] = covered(x, coarse, fine.width);
    for (int column = begin; column < end; ++column, texel += 4) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += color.linear(texel[c]);
      sum[3] += alpha.linear(texel[3]);
    }
  }
}

}  // namespace

Vec2i halved(Vec2i size) { return {std::max(1, size.x / 2), std::max(1, size.y / 2)}; }

std::vector<int> halvings_within(std::uint64_t bytes, std::span<const TextureExtent> textures) {
  std::vector<int> halvings(textures.size(), 0);
  using Candidate = std::tuple<std::uint64_t, bool, std::size_t>;
  std::priority_queue<Candidate> largest;
  std::vector<Vec2i> sizes;
  std::uint64_t left = 0;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    sizes.push_back(textures[i].size);
    largest.emplace(texels(sizes[i]), textures[i].is_data, i);
    left += 4 * texels(sizes[i]);
  }
  while (left > bytes && !largest.empty() && std::get<0>(largest.top()) > 1) {
    const auto [before, is_data, i] = largest.top();
    largest.pop();
    sizes[i] = halved(sizes[i]);
    ++halvings[i];
    left -= 4 * (before - texels(sizes[i]));
    largest.emplace(texels(sizes[i]), is_data, i);
  }
  return halvings;
}

void halve(Texture& texture) {
  static const Curve kColor(true), kData(false);
  const Vec2i size = halved({texture.width, texture.height});
  const Curve& color = texture.srgb ? kColor : kData;
  std::vector<std::uint8_t> coarse;
  coarse.reserve(4 * static_cast<std::size_t>(texels(size)));
  std::vector<std::uint32_t> sums;
  for (int y = 0; y < size.y; ++y) {
    const Covered rows = covered(y, size.y, texture.height);
    sums.assign(4 * static_cast<std::size_t>(size.x), 0);
    for (int row = rows.begin; row < rows.end; ++row) add_row(texture, row, size.x, color, kData, sums);
    for (int x = 0; x < size.x; ++x) {
      const Covered columns = covered(x, size.x, texture.width);
      const auto count = static_cast<std::uint32_t>((columns.end - columns.begin) * (rows.end - rows.begin));
      for (std::size_t c = 0; c < 4; ++c)
        coarse.push_back((c < 3 ? color : kData).code((sums[4 * static_cast<std::size_t>(x) + c] + count / 2) / count));
    }
  }
  texture.width = size.x, texture.height = size.y;
  texture.rgba = std::move(coarse);
}

}  // namespace lippmann
