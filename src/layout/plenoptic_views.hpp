// Views of a raw plenoptic picture: one sample of each view below each lens.
//
// View (a, b) of a C x R grid is sampled a - (C - 1) / 2 pixels right and b - (R - 1) / 2 pixels above the centre of every
// lens, along the axes of the lens grid (the other way round if the calibration says inverted). A view has one pixel per lens
// of the largest rectangle of lenses within the picture. Rows of hexagonal grids are resampled to square pixels, as wide as
// rows are apart.
#pragma once

#include <filesystem>
#include <string>

#include "lippmann/layout/lens_grid.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Divides light by the white picture, of the same size; what gets less than a twentieth of the light is divided by that.
/// Throws Error naming `where` if the sizes differ.
void divide_by_white(Image& light, const Image& white, const std::string& where);

/// The grey of a picture of flat white light, 1 where it is brightest (the upper half percent), 1 channel.
Image white_shares(const Image& light);

/// The white_shares of a picture file. Throws Error naming the file.
Image read_white(const std::filesystem::path& path);

/// The number of views that are sampled by default: as many as whole pixels lie below a lens.
ViewGrid default_plenoptic_views(const LensGrid& grid);

/// `light`: linear, 3 channels. `like`: a picture with samples of the kind that views get. calibration.grid is given;
/// calibration.white is not looked at. Throws Error naming `where` if fewer than 2 x 2 lenses lie in the picture, and a usage
/// Error naming "views" for more views than pixels below a lens.
LightField plenoptic_views(const Image& light, const PlenopticCalibration& calibration, ViewGrid views, const Picture& like,
                           const std::string& where);

}  // namespace lippmann
