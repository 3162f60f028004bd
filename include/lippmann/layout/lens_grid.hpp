// The lattice of lens images in the raw picture of a plenoptic camera.
//
// Coordinates are in pixels from the top left of the picture, with pixel centres at +0.5. Lens (i, j) of a square or hexagonal
// grid has its centre at
//   offset_px + R(rotation) (pitch_px (i + s), row_pitch_px j),  s = 1/2 in the odd rows of a hexagonal grid, else 0,
// where R turns x towards y: clockwise in the picture. i and j may be negative.
#pragma once

#include <memory>
#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

enum class LensArrangement {
  kSquare,
  kHexagonal,         ///< every odd row is shifted by half a pitch
  kHexagonalColumns,  ///< every odd column is shifted by half a pitch: x and y of the formula are swapped
};

struct LensGrid {
  double pitch_px = 10.0;      ///< between neighbours in a row
  double row_pitch_px = 10.0;  ///< between rows
  double rotation = 0.0;
  Vec2d offset_px{5.0, 5.0};  ///< the centre of any one lens
  LensArrangement arrangement = LensArrangement::kSquare;

  bool operator==(const LensGrid&) const = default;
};

/// Returns a grid of equally spaced lenses: the row pitch is pitch_px, or pitch_px sqrt(3) / 2 if it is hexagonal.
LensGrid lens_grid(double pitch_px, double rotation, Vec2d offset_px, LensArrangement arrangement);

/// Returns the same lenses with x and y of the picture swapped.
LensGrid transposed(const LensGrid& grid);

/// Returns the centre of a lens. Transpose kHexagonalColumns first.
Vec2d lens_centre(const LensGrid& grid, int column, int row);

/// The settings for turning a raw picture into views (FormatOptions::plenoptic).
struct PlenopticCalibration {
  std::optional<LensGrid> grid = {};  ///< none: from the picture's container or side file
  /// The relative light at each pixel, 1 channel, 1 where it is brightest; null: views keep their vignetting.
  std::shared_ptr<const Image> white = {};
  bool lanczos = false;   ///< interpolation between pixels, and between lenses of hexagonal grids; false: linear
  bool inverted = false;  ///< the pixels below each lens are rotated by 180 degrees, as behind the lenses of a display
};

}  // namespace lippmann
