// The panorama as patches between its texels: finds the sun and samples directions exactly in proportion to the bilinear light.
//
// A patch lies between the centres of four neighbouring texels, where the light is bilinear. There are as many columns of
// patches as of texels (the last column wraps around) and one row more: the first and the last row have half the height and lie
// between the poles and the outermost texels. Row 0 is at the top.
//
// Patches are stored in tiles of 8 x 8. Each tile holds all texels that its patches touch, so a lookup is local: a panorama
// exceeds the cache of a core, and directions are incoherent.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "lippmann/core/math.hpp"
#include "transport/bsdf.hpp"
#include "transport/discrete.hpp"

namespace lippmann {

/// The light of a grid of texels over the sphere, as patches.
class SkyPatches {
 public:
  /// Patches along each side of a tile.
  static constexpr int kTile = 8;
  /// Distances in floats between channels of a row, between rows, and between tiles. Offsets in the largest panorama
  /// (EnvironmentMap) are below 2^31.
  struct Layout {
    int channel = kTile + 1, row = 3 * channel, tile = 244;
  };
  /// Layout if all light is grey, as in a studio: the channels share one value.
  static constexpr Layout kGrey{0, kTile + 1, 84};

  /// light: returns the light of a texel at x in [0, width), y in [0, height). It must be finite and not negative.
  SkyPatches(int width, int height, const std::function<Vec3f(int x, int y)>& light);

  int width() const { return width_; }
  int height() const { return height_; }
  float texel_solid_angle(int y) const;
  Vec3f texel(int x, int y) const;

  /// A position on the sphere.
  struct Place {
    int x = 0, y = 0;  ///< column and row of the patch
    Vec2f within{
        0.0f};  ///< in [0, 1]: across in azimuth, down in the cosine of the polar angle, so it is uniform in solid angle
  };
  /// across_down: azimuth and polar angle as shares of their ranges, in [0, 1). cosine: of the polar angle.
  Place at(Vec2f across_down, float cosine) const;

  int rows() const { return height_ + 1; }
  std::size_t patch(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  float patch_solid_angle(int y) const {
    return (cosine_above(y) - cosine_above(y + 1)) * 2.0f * kPi / static_cast<float>(width_);
  }
  /// Returns the cosine of the polar angle at the top of a row of patches.
  float cosine_above(int y) const { return cosines_[static_cast<std::size_t>(y)]; }

  // Tiles at the right and the bottom edge may hold fewer patches.
  int tiles_across() const { return tiles_across_; }
  int tiles_down() const { return (rows() + kTile - 1) / kTile; }
  std::size_t tile(int tile_x, int tile_y) const {
    return static_cast<std::size_t>(tile_y) * static_cast<std::size_t>(tiles_across_) + static_cast<std::size_t>(tile_x);
  }
  const Layout& layout() const { return layout_; }
  /// Returns a tile's texels, row by row; in each row red, then green, then blue.
  const float* texels_of(std::size_t tile) const { return texels_.data() + static_cast<std::size_t>(layout_.tile) * tile; }
  /// Returns the red value of the upper left corner of a patch. The next float is that of the upper right corner.
  const float* corner(int x, int y) const {
    return texels_of(tile(x / kTile, y / kTile)) + layout_.row * (y % kTile) + x % kTile;
  }
  /// Returns the luminance at the patch's corners: upper left, upper right, lower left, lower right.
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

/// Indexed by SkyPatches::patch.
using PatchMask = std::vector<bool>;

/// Returns the patches of the sun: those that touch texels of at least 50 times the mean luminance. The threshold doubles until
/// the patches fit into 0.02 steradian. Returns an empty mask if these texels have less than a tenth of all light. Veiled suns
/// and large windows thus do not count as a sun; their shadows are soft.
PatchMask find_sun(const SkyPatches& sky);

/// Samples positions in a subset of a sky's patches by luminance: first a tile, then a row of the tile, a patch of the row, and
/// a position within the patch.
class PatchChoice {
 public:
  PatchChoice() = default;  ///< has no patches
  PatchChoice(const SkyPatches& sky, const std::function<bool(std::size_t patch)>& is_of);

  bool is_dark() const { return tile_rows_.empty(); }
  /// Returns the integral of luminance over solid angle.
  double total() const { return tile_rows_.total(); }

  // Sampling has two steps, so that many directions can be sampled together: the first step prefetches the memory that the
  // second one reads.
  /// A row of patches within a tile.
  struct Row {
    std::size_t tile;
    int tile_x, y;
    Vec2f rest;                   ///< remainder of the random numbers
    float density_per_luminance;  ///< density per steradian and unit of luminance, anywhere in the row
  };
  /// Chooses a row. Requires !is_dark(). `sky` must be the constructor's. u in [0, 1).
  Row draw_row(const SkyPatches& sky, Vec2f u) const;
  /// A chosen patch of a row.
  struct Drawn {
    int x, y;
    Vec2f rest;
    float density_per_luminance;
  };
  Drawn draw_patch(const SkyPatches& sky, const Row& row) const;

  /// Returns the density with which a position is sampled, per steradian; 0 outside this object's patches.
  float density(const SkyPatches& sky, const SkyPatches::Place& place) const;

 private:
  /// Rows of patches within a tile; one cache line.
  struct alignas(64) TileRows {
    std::array<float, SkyPatches::kTile> upto;                   ///< cumulative share of the tile's light
    std::array<float, SkyPatches::kTile> density_per_luminance;  ///< as in Row, for each row
  };
  using RowOfPatches = std::array<float, SkyPatches::kTile>;
  float add_tile(const SkyPatches& sky, int tile_x, int tile_y, const std::function<bool(std::size_t patch)>& is_of);
  RowOfPatches weights_of(const SkyPatches& sky, std::size_t tile, int row) const;
  void set_densities(const SkyPatches& sky, int tile_x, int tile_y);

  DiscreteDistribution tile_rows_;
  std::vector<DiscreteDistribution> tiles_;  ///< distributions of the tiles, one per row of tiles
  std::vector<TileRows> rows_;               ///< by tile
  std::vector<std::uint8_t> own_;            ///< by tile and row within it: one bit per patch that may be drawn
};

}  // namespace lippmann
