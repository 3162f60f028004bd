// Extracts views from a raw plenoptic picture: one sample per view below each lens. View (a, b) of a C x R grid is
// sampled a - (C - 1) / 2 pixels to the right and b - (R - 1) / 2 pixels up from the centre of every lens, along the
// axes of the lens grid, or in the opposite directions if the calibration is inverted. A view has one pixel per lens in
// the largest rectangle of lenses within the picture. In hexagonal grids, rows are resampled to square pixels of the
// size of the row pitch.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/layout/lens_grid.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Divides `light` by `white`, whose values below 1/20 are treated as 1/20. Throws Error naming `where` if the sizes differ.
void divide_by_white(Image& light, const Image& white, const std::string& where);

/// Returns the grey values (1 channel) of a picture of uniform white light. They are scaled so that the brightest 0.5 % of
/// the pixels are at least 1.
Image white_shares(const Image& light);

/// Reads a white picture and returns its white_shares(). Throws Error naming the file.
Image read_white(const std::filesystem::path& path);

/// Returns one view per whole pixel below a lens, across and up.
ViewGrid default_plenoptic_views(const LensGrid& grid);

/// Extracts the views of `light` (linear, 3 channels). `like`: a picture with the sample type that the result should have.
/// calibration.grid must be set; calibration.white is ignored. Throws Error naming `where` if fewer than 2 x 2 lenses lie in
/// the picture. Throws a usage Error naming "views" if there are more views than pixels below a lens.
///
/// If calibration.optics is set, the rows of the grid are level and the picture has the size of the sensor, sets the cameras
/// and, from `z_mm`, the depth. `z_mm`: z of every pixel of `light` in the display frame; null: unknown. A view's pixel takes
/// the depth of the nearest pixel of `light` below the nearest lens.
LightField plenoptic_views(const Image& light, const PlenopticCalibration& calibration, ViewGrid views, const Picture& like,
                           const std::string& where, const Image* z_mm = nullptr);

}  // namespace lippmann
