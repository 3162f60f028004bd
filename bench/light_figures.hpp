// How far frames are from their references, and how much they flicker from view to view and from frame to frame. All of 8-bit
// codes, on some rows of each frame: references of thousands of samples a pixel are too dear for all of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/image.hpp"
#include "optics/optics.hpp"

namespace lippmann::bench {

/// One panel row of every `share`, drawn evenly and always the same, ascending. Of quilts the same rows of every tile, so that
/// neighbouring views can be compared.
std::vector<int> rows_to_compare(const Optics& optics, int share);

/// Those rows, one below the other.
Image8 take_rows(const Image8& picture, const std::vector<int>& rows);

/// Three pixels of neighbouring directional views, by their index in the picture of the compared rows: three in a row below one
/// lens, the same tile pixel of three neighbouring tiles. None for optics that have no such structure.
using ViewTriple = std::array<std::uint32_t, 3>;
std::vector<ViewTriple> neighbouring_views(const Optics& optics, const std::vector<int>& rows);

/// Frames of an animation, the compared rows of each.
using Frames = std::vector<Image8>;

/// Over all frames, pixels and channels; in codes squared. As many frames in both, of one size.
double mean_squared_error(const Frames& reference, const Frames& test);

/// Mean of |a - 2 b + c| in codes over neighbouring views, and over three frames at a pixel. Not a number where there are no
/// three.
double view_flicker(const Frames& frames, const std::vector<ViewTriple>& views);
double frame_flicker(const Frames& frames);

/// Full renders at several numbers of samples: what their PSNR would be at a time between them, in proportion to the logarithm
/// of time. Beyond the ends: that of the nearest.
struct TimedQuality {
  int spp = 1;
  double seconds = 0.0, psnr_db = 0.0;
};
double psnr_at_time(std::vector<TimedQuality> measured, double seconds);

}  // namespace lippmann::bench
