// The lattice of lenses in the raw picture of a plenoptic camera: where the centre of each lens's image lies.
//
// Pixels are counted from the top left of the picture, with centres at +0.5. Lens (i, j) of a square or hexagonal grid lies at
//   offset_px + R(rotation) (pitch_px (i + s), row_pitch_px j),  s = 1/2 in the odd rows of a hexagonal grid, else 0,
// where R turns x towards y: clockwise as the picture is seen. i and j may be below 0.
#pragma once

#include <memory>
#include <optional>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

enum class LensArrangement {
  kSquare,
  kHexagonal,         ///< each next row is shifted by half a pitch
  kHexagonalColumns,  ///< each next column is shifted by half a pitch: x and y of everything above are swapped
};

struct LensGrid {
  double pitch_px = 10.0;      ///< between neighbours in a row
  double row_pitch_px = 10.0;  ///< between rows
  double rotation = 0.0;
  Vec2d offset_px{5.0, 5.0};  ///< the centre of any one lens
  LensArrangement arrangement = LensArrangement::kSquare;

  bool operator==(const LensGrid&) const = default;
};

/// A grid whose rows are as far apart as those of equal lenses: pitch_px, or pitch_px sqrt(3) / 2 where it is hexagonal.
LensGrid lens_grid(double pitch_px, double rotation, Vec2d offset_px, LensArrangement arrangement);

/// The same lenses where x and y of the picture are swapped.
LensGrid transposed(const LensGrid& grid);

/// The centre of a lens. Not for kHexagonalColumns: transposed() first.
Vec2d lens_centre(const LensGrid& grid, int column, int row);

/// Everything that turns a raw picture into views (FormatOptions::plenoptic).
struct PlenopticCalibration {
  std::optional<LensGrid> grid = {};  ///< none: the one that the picture's container or side file states
  /// The share of the light that reaches each pixel, 1 channel, 1 where it is brightest; null: views keep their vignetting.
  std::shared_ptr<const Image> white = {};
  bool lanczos = false;   ///< samples between pixels, and between lenses of hexagonal grids: by Lanczos, else linear
  bool inverted = false;  ///< the pixels below each lens are turned round, as behind the lenses of a display
};

}  // namespace lippmann
