// Divides a panorama into patches between its texels. Finds the sun, and samples directions exactly in proportion to the
// bilinearly interpolated luminance.
//
// A patch lies between the centres of four neighbouring texels. The number of columns of patches equals that of texels, because
// the last column wraps around. There is one row of patches more than rows of texels. The first and the last row have half the
// height, because they lie between the poles and the outermost texels. Row 0 is at the top.
//
// Patches are stored in tiles of 8 x 8. Each tile holds all texels that its patches touch, so that a lookup reads memory at one
// place. This matters because directions are incoherent, and a panorama exceeds the cache of a core.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "lippmann/core/math.hpp"
#include "transport/bsdf.hpp"
#include "transport/discrete.hpp"

namespace lippmann {

/// The light of a grid of texels over the sphere, divided into patches.
class SkyPatches {
 public:
  /// Number of patches along each side of a tile.
  static constexpr int kTile = 8;
  /// Memory layout: distances in floats between the channels of a row, between rows, and between tiles. Offsets in the largest
  /// panorama (EnvironmentMap) are below 2^31.
  struct Layout {
    int channel = kTile + 1, row = 3 * channel, tile = 244;
  };
  /// Memory layout if all light is grey, as in a studio. The channels share one value.
  static constexpr Layout kGrey{0, kTile + 1, 84};

  /// `light` returns the light of the texel in column x and row y. The light must be finite and not negative.
  SkyPatches(int width, int height, const std::function<Vec3f(int x, int y)>& light);

  int width() const { return width_; }
  int height() const { return height_; }
  float texel_solid_angle(int y) const;
  Vec3f texel(int x, int y) const;

  /// A position on the sphere: a patch, and coordinates within the patch.
  struct Place {
    int x = 0, y = 0;    ///< column and row of the patch
    Vec2f within{0.0f};  ///< in [0, 1]: x in azimuth, y in the cosine of the polar angle, so that it is uniform in solid angle
  };
  /// Returns the position of a direction. across_down: azimuth as a share of a turn and polar angle as a share of half a turn,
  /// in [0, 1). cosine: cosine of the polar angle.
  Place at(Vec2f across_down, float cosine) const;

  int rows() const { return height_ + 1; }
  std::size_t patch(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  float patch_solid_angle(int y) const {
    return (cosine_above(y) - cosine_above(y + 1)) * 2.0f * kPi / static_cast<float>(width_);
  }
  /// Returns the cosine of the polar angle at the top of row y of patches.
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
  /// Returns the luminance of a texel, given the address of its red value.
  float luminance_at(const float* red) const {
    return luminance(Vec3f(red[0], red[layout_.channel], red[2 * layout_.channel]));
  }

 private:
  int width_, height_, tiles_across_;
  Layout layout_;
  std::vector<float> texels_;
  std::vector<float> cosines_;
};

/// One element per patch, indexed by SkyPatches::patch().
using PatchMask = std::vector<bool>;

/// Returns the patches of the sun, or an empty mask if there is none:
/// 1. The threshold is 50 times the mean luminance.
/// 2. The sun's patches touch texels above the threshold.
/// 3. The threshold doubles until these patches fit into 0.02 steradian.
/// 4. There is no sun if these texels have less than a tenth of all light.
/// Veiled suns and large windows thus do not count as a sun, because their shadows are soft.
PatchMask find_sun(const SkyPatches& sky);

/// Samples positions in a subset of a sky's patches in proportion to luminance: first a tile, then a row of the tile, then a
/// patch of the row, and last a position within the patch.
class PatchChoice {
 public:
  PatchChoice() = default;  ///< samples no patches
  PatchChoice(const SkyPatches& sky, const std::function<bool(std::size_t patch)>& is_of);

  bool is_dark() const { return tile_rows_.empty(); }
  /// Returns the integral of luminance over the solid angle of all patches.
  double total() const { return tile_rows_.total(); }

  // Sampling has two steps, draw_row() and draw_patch(), so that many directions can be sampled together. The first step
  // prefetches the memory that the second step reads.
  /// The result of draw_row(): a row of patches within a tile.
  struct Row {
    std::size_t tile;
    int tile_x, y;
    Vec2f rest;                   ///< unused part of the random numbers, in [0, 1)
    float density_per_luminance;  ///< density per steradian divided by luminance, the same for all positions in the row
  };
  /// Chooses a row by u in [0, 1). Requires !is_dark(). `sky` must be the same as in the constructor.
  Row draw_row(const SkyPatches& sky, Vec2f u) const;
  /// The result of draw_patch(): a patch, with rest and density_per_luminance as in Row.
  struct Drawn {
    int x, y;
    Vec2f rest;
    float density_per_luminance;
  };
  Drawn draw_patch(const SkyPatches& sky, const Row& row) const;

  /// Returns the density per steradian with which a position is sampled. Returns 0 for positions outside the subset.
  float density(const SkyPatches& sky, const SkyPatches::Place& place) const;

 private:
  /// The rows of patches in a tile. The size is one cache line.
  struct alignas(64) TileRows {
    std::array<float, SkyPatches::kTile> upto;                   ///< cumulative shares of the tile's light, one per row
    std::array<float, SkyPatches::kTile> density_per_luminance;  ///< density per steradian divided by luminance, one per row
  };
  using RowOfPatches = std::array<float, SkyPatches::kTile>;
  float add_tile(const SkyPatches& sky, int tile_x, int tile_y, const std::function<bool(std::size_t patch)>& is_of);
  RowOfPatches weights_of(const SkyPatches& sky, std::size_t tile, int row) const;
  void set_densities(const SkyPatches& sky, int tile_x, int tile_y);

  DiscreteDistribution tile_rows_;
  std::vector<DiscreteDistribution> tiles_;  ///< one distribution of tiles for each row of tiles
  std::vector<TileRows> rows_;               ///< one element per tile
  std::vector<std::uint8_t> own_;  ///< one element per row of each tile; bit i is 1 if this choice includes patch i of the row
};

}  // namespace lippmann
