// A panorama's light between its texels: which part of it is a sun, and directions drawn exactly by the light that is looked up
// bilinearly.
//
// A patch lies between the centres of four neighbouring texels, where looked-up light is bilinear. There are as many columns of
// patches as of texels (the last one leads round to the first texels) and one row more: the first and the last row are half as
// high and lie between the poles and the outermost texels. Rows count from straight up.
//
// Patches lie in memory by tiles of 8 x 8, each with all the texels that its patches touch, so that what a direction needs is
// near by: a panorama is larger than a core's cache, and directions into it go everywhere.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "lippmann/core/math.hpp"
#include "transport/bsdf.hpp"
#include "transport/discrete.hpp"

namespace lippmann {

/// The light of a grid of texels over the sphere, seen as patches.
class SkyPatches {
 public:
  /// Patches of a tile, along each side.
  static constexpr int kTile = 8;
  /// Where a tile's texels lie: floats from a channel of a row to the next channel, from a row to the one below, and from a
  /// tile to the next. Of the largest panorama (EnvironmentMap) they are fewer than 2^31.
  struct Layout {
    int channel = kTile + 1, row = 3 * channel, tile = 244;
  };
  /// Where all light is grey, as the studio's: channels are one.
  static constexpr Layout kGrey{0, kTile + 1, 84};

  /// light: of a texel, at x in [0, width) and y in [0, height); finite and not negative.
  SkyPatches(int width, int height, const std::function<Vec3f(int x, int y)>& light);

  int width() const { return width_; }
  int height() const { return height_; }
  float texel_solid_angle(int y) const;
  Vec3f texel(int x, int y) const;

  /// Somewhere on the sphere.
  struct Place {
    int x = 0, y = 0;    ///< the patch's column and row
    Vec2f within{0.0f};  ///< in [0, 1]: across in azimuth, down in the cosine of the polar angle, which is even in solid angle
  };
  /// across, down: shares of the turn and of the polar angle, in [0, 1); `cosine`: the polar angle's.
  Place at(Vec2f across_down, float cosine) const;

  int rows() const { return height_ + 1; }
  std::size_t patch(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  float patch_solid_angle(int y) const {
    return (cosine_above(y) - cosine_above(y + 1)) * 2.0f * kPi / static_cast<float>(width_);
  }
  /// Cosine of the polar angle at the top of a row of patches.
  float cosine_above(int y) const { return cosines_[static_cast<std::size_t>(y)]; }

  // Tiles; those on the right and at the bottom may hold fewer patches than others.
  int tiles_across() const { return tiles_across_; }
  int tiles_down() const { return (rows() + kTile - 1) / kTile; }
  std::size_t tile(int tile_x, int tile_y) const {
    return static_cast<std::size_t>(tile_y) * static_cast<std::size_t>(tiles_across_) + static_cast<std::size_t>(tile_x);
  }
  const Layout& layout() const { return layout_; }
  /// Of a tile's texels, row by row, all that is red, green and blue.
  const float* texels_of(std::size_t tile) const { return texels_.data() + static_cast<std::size_t>(layout_.tile) * tile; }
  /// Red of the upper left corner of a patch. One float on is that of the upper right one.
  const float* corner(int x, int y) const {
    return texels_of(tile(x / kTile, y / kTile)) + layout_.row * (y % kTile) + x % kTile;
  }
  /// Luminance at the patch's corners: upper left, upper right, lower left, lower right.
  std::array<float, 4> corners(int x, int y) const;
  /// Of a texel, by where its red is.
  float luminance_at(const float* red) const {
    return luminance(Vec3f(red[0], red[layout_.channel], red[2 * layout_.channel]));
  }

 private:
  int width_, height_, tiles_across_;
  Layout layout_;
  std::vector<float> texels_;
  std::vector<float> cosines_;
};

/// By SkyPatches::patch.
using PatchMask = std::vector<bool>;

/// The patches of a sun: those that touch texels of at least 50 times the mean luminance, a level that is doubled until they
/// fit into 0.02 steradian; no patches (an empty mask) where these texels have less than a tenth of all light. So neither
/// panoramas with a sun that clouds veil nor those with large windows have one: their shadows are soft.
PatchMask find_sun(const SkyPatches& sky);

/// Draws places of some of a sky's patches by their luminance: a tile, a row of its patches, a patch of that row, and a place
/// within the patch.
class PatchChoice {
 public:
  PatchChoice() = default;  ///< has no patches
  PatchChoice(const SkyPatches& sky, const std::function<bool(std::size_t patch)>& is_of);

  bool is_dark() const { return tile_rows_.empty(); }
  /// Luminance over solid angle.
  double total() const { return tile_rows_.total(); }

  // Drawing goes by steps, so that many directions can be drawn side by side: what the second step reads is asked of memory by
  // the first.
  /// A row of patches within a tile.
  struct Row {
    std::size_t tile;
    int tile_x, y;
    Vec2f rest;                   ///< of the numbers that have drawn it
    float density_per_luminance;  ///< per steradian, of all places in it
  };
  /// Not where is_dark(). `sky` is that which it was made for. u in [0, 1).
  Row draw_row(const SkyPatches& sky, Vec2f u) const;
  /// One of its patches.
  struct Drawn {
    int x, y;
    Vec2f rest;
    float density_per_luminance;
  };
  Drawn draw_patch(const SkyPatches& sky, const Row& row) const;

  /// The density with which a place is drawn, per steradian; 0 in patches that are not its own.
  float density(const SkyPatches& sky, const SkyPatches::Place& place) const;

 private:
  /// Of the rows of patches within a tile; a line of a cache.
  struct alignas(64) TileRows {
    std::array<float, SkyPatches::kTile> upto;                   ///< share of the tile's light, with the rows above
    std::array<float, SkyPatches::kTile> density_per_luminance;  ///< as Row's
  };
  using RowOfPatches = std::array<float, SkyPatches::kTile>;
  float add_tile(const SkyPatches& sky, int tile_x, int tile_y, const std::function<bool(std::size_t patch)>& is_of);
  RowOfPatches weights_of(const SkyPatches& sky, std::size_t tile, int row) const;
  void set_densities(const SkyPatches& sky, int tile_x, int tile_y);

  DiscreteDistribution tile_rows_;
  std::vector<DiscreteDistribution> tiles_;  ///< by row of tiles
  std::vector<TileRows> rows_;               ///< by tile
  std::vector<std::uint8_t> own_;            ///< by tile and row in it: a bit for every patch that may be drawn
};

}  // namespace lippmann
