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
#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class LensArrangement {
  kSquare,
  kHexagonal,         ///< odd rows are shifted by half a pitch
  kHexagonalColumns,  ///< odd columns are shifted by half a pitch: x and y in the formula at the top are exchanged
};

struct LensGrid {
  double pitch_px = 10.0;      ///< between neighbouring lenses in a row
  double row_pitch_px = 10.0;  ///< between neighbouring rows
  double rotation = 0.0;
  Vec2d offset_px{5.0, 5.0};  ///< centre of any lens
  LensArrangement arrangement = LensArrangement::kSquare;

  bool operator==(const LensGrid&) const = default;
};

/// Returns a grid of equally spaced lenses. The row pitch is pitch_px for a square grid, and pitch_px sqrt(3) / 2 for a
/// hexagonal grid.
LensGrid lens_grid(double pitch_px, double rotation, Vec2d offset_px, LensArrangement arrangement);

/// Returns the lens grid of a plenoptic camera, or none for other optics.
std::optional<LensGrid> lens_grid_of(const Optics& optics);

/// Returns the grid of the elemental images on a panel behind microlenses, or none for other optics. The pixels of an elemental
/// image are rotated by 180 degrees (PlenopticCalibration::inverted).
std::optional<LensGrid> elemental_images(const Optics& optics);

/// Returns the same lenses for a picture with x and y exchanged.
LensGrid transposed(const LensGrid& grid);

/// Returns the centre of a lens in pixels. For kHexagonalColumns, call transposed() first.
Vec2d lens_centre(const LensGrid& grid, int column, int row);

/// Settings for turning a raw picture into views.
struct PlenopticCalibration {
  std::optional<LensGrid> grid = {};  ///< none: from the picture's container or side file
  /// Relative illumination, 1 at the brightest pixel. Null: views keep their vignetting.
  std::shared_ptr<const Image> white = {};
  bool lanczos = false;  ///< Lanczos interpolation between pixels, and between lenses of hexagonal grids; otherwise linear
  /// The pixels below each lens are rotated by 180 degrees, as behind the lenses of a display.
  bool inverted = false;
  /// Optics that rendered the picture. None: the cameras of the views are unknown.
  std::optional<Optics> optics = {};
};

}  // namespace lippmann
