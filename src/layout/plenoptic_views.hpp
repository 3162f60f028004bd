// Extracts views from a raw plenoptic picture: one sample per view below each lens.
//
// View (a, b) of a C x R grid is sampled a - (C - 1) / 2 pixels right and b - (R - 1) / 2 pixels above the centre of every
// lens, along the axes of the lens grid (in opposite directions if the calibration is inverted). A view has one pixel per lens
// in the largest rectangle of lenses within the picture. Rows of hexagonal grids are resampled to square pixels of the row
// pitch.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/layout/lens_grid.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Divides light by a white picture of the same size; white values below a twentieth are clamped. Throws Error naming `where`
/// if the sizes differ.
void divide_by_white(Image& light, const Image& white, const std::string& where);

/// Returns the grey of a picture of uniform white light, normalised to 1 at its brightest (the upper half percent), 1 channel.
Image white_shares(const Image& light);

/// Reads a white picture and returns its white_shares(). Throws Error naming the file.
Image read_white(const std::filesystem::path& path);

/// Returns the default number of views: the whole pixels below a lens.
ViewGrid default_plenoptic_views(const LensGrid& grid);

/// Extracts the views of `light` (linear, 3 channels). `like`: a picture with the sample type of the result. calibration.grid
/// must be set; calibration.white is ignored. Throws Error naming `where` if fewer than 2 x 2 lenses lie in the picture, and a
/// usage Error naming "views" for more views than pixels below a lens.
LightField plenoptic_views(const Image& light, const PlenopticCalibration& calibration, ViewGrid views, const Picture& like,
                           const std::string& where);

}  // namespace lippmann
