// Divides a panorama into patches, finds the sun, and samples directions in proportion to the bilinearly interpolated
// luminance.
//
// A patch lies between the centres of four neighbouring texels. The last column of patches wraps around. There is one row of
// patches more than rows of texels, because the first and the last row lie between the poles and the outermost texels. Row 0 is
// at the top.
//
// Patches are stored in tiles of 8 x 8 with all their texels, so that a lookup reads memory at one place.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "lippmann/core/math.hpp"
#include "transport/bsdf.hpp"
#include "transport/discrete.hpp"

namespace lippmann {

class SkyPatches {
 public:
  static constexpr int kTile = 8;
  /// Distances in floats between the channels of a row, between rows, and between tiles.
  struct Layout {
    int channel = kTile + 1, row = 3 * channel, tile = 244;
  };
  /// For grey light, all channels share one value.
  static constexpr Layout kGrey{0, kTile + 1, 84};

  SkyPatches(int width, int height, const std::function<Vec3f(int x, int y)>& light);

  int width() const { return width_; }
  int height() const { return height_; }
  float texel_solid_angle(int y) const;
  Vec3f texel(int x, int y) const;

  /// A position on the sphere: a patch, and coordinates within the patch.
  struct Place {
    int x = 0, y = 0;    ///< column and row of the patch
    Vec2f within{0.0f};  ///< in [0, 1]: x in azimuth, y in the cosine of the polar angle
  };
  /// Returns the position of a direction. across_down: azimuth / (2 pi) and polar angle / pi, in [0, 1). cosine: cosine of the
  /// polar angle.
  Place at(Vec2f across_down, float cosine) const;

  int rows() const { return height_ + 1; }
  std::size_t patch(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  float patch_solid_angle(int y) const {
    return (cosine_above(y) - cosine_above(y + 1)) * 2.0f * kPi / static_cast<float>(width_);
  }
  float cosine_above(int y) const { return cosines_[static_cast<std::size_t>(y)]; }

  // Tiles are numbered from left to right and top to bottom. Those at the right and bottom edge may hold fewer patches.
  int tiles_across() const { return tiles_across_; }
  int tiles_down() const { return (rows() + kTile - 1) / kTile; }
  std::size_t tile(int tile_x, int tile_y) const {
    return static_cast<std::size_t>(tile_y) * static_cast<std::size_t>(tiles_across_) + static_cast<std::size_t>(tile_x);
  }
  const Layout& layout() const { return layout_; }
  /// Returns a tile's texels, row by row. A row holds all red values, then all green values, then all blue values.
  const float* texels_of(std::size_t tile) const { return texels_.data() + static_cast<std::size_t>(layout_.tile) * tile; }
  /// Returns the address of the red value at a patch's upper left corner. The upper right corner's red value follows it.
  const float* corner(int x, int y) const {
    return texels_of(tile(x / kTile, y / kTile)) + layout_.row * (y % kTile) + x % kTile;
  }
  /// Returns the luminance at a patch's corners: upper left, upper right, lower left, lower right.
  std::array<float, 4> corners(int x, int y) const;
  float luminance_at(const float* red) const {
    return luminance(Vec3f(red[0], red[layout_.channel], red[2 * layout_.channel]));
  }

 private:
  int width_, height_, tiles_across_;
  Layout layout_;
  std::vector<float> texels_;
  std::vector<float> cosines_;
};

using PatchMask = std::vector<bool>;

/// Returns the patches of the sun, or an empty mask if there is none:
/// 1. The threshold is 50 times the mean luminance.
/// 2. The sun's patches touch texels above the threshold.
/// 3. The threshold doubles until these patches fit into 0.02 steradian.
/// 4. There is no sun if these texels have less than a tenth of all light, as with veiled suns and large windows.
PatchMask find_sun(const SkyPatches& sky);

/// Samples positions in a subset of a sky's patches in proportion to luminance: first a tile, then a row of the tile, then a
/// patch of the row, and last a position within the patch.
class PatchChoice {
 public:
  PatchChoice() = default;
  PatchChoice(const SkyPatches& sky, const std::function<bool(std::size_t patch)>& is_of);

  bool is_dark() const { return tile_rows_.empty(); }
  double total() const { return tile_rows_.total(); }

  // Sampling has two steps, so that many directions can be sampled together: draw_row() prefetches the memory that draw_patch()
  // reads.
  struct Row {
    std::size_t tile;
    int tile_x, y;
    Vec2f rest;
    float density_per_luminance;
  };
  /// Chooses a row by u in [0, 1). Requires !is_dark(). `sky` must be the same as in the constructor.
  Row draw_row(const SkyPatches& sky, Vec2f u) const;
  struct Drawn {
    int x, y;
    Vec2f rest;
    float density_per_luminance;
  };
  Drawn draw_patch(const SkyPatches& sky, const Row& row) const;

  /// Returns the probability density per steradian of a position, or 0 outside the subset.
  float density(const SkyPatches& sky, const SkyPatches::Place& place) const;

 private:
  /// The rows of patches in a tile. The size is one cache line.
  struct alignas(64) TileRows {
    std::array<float, SkyPatches::kTile> upto;
    std::array<float, SkyPatches::kTile> density_per_luminance;
  };
  using RowOfPatches = std::array<float, SkyPatches::kTile>;
  float add_tile(const SkyPatches& sky, int tile_x, int tile_y, const std::function<bool(std::size_t patch)>& is_of);
  RowOfPatches weights_of(const SkyPatches& sky, std::size_t tile, int row) const;
  void set_densities(const SkyPatches& sky, int tile_x, int tile_y);

  DiscreteDistribution tile_rows_;
  std::vector<DiscreteDistribution> tiles_;
  std::vector<TileRows> rows_;
  std::vector<std::uint8_t> own_;  ///< one element per row of each tile; bit i is set if patch i of the row is in the subset
};

}  // namespace lippmann
