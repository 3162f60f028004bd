// Pictures shot by hand or on a slider as the views of a row of cameras.
//
// A row of cameras sees every place of the scene at the same height; how far it moves sideways says how deep it lies. Each
// picture is turned, scaled and shifted up or down as heights demand (align/similarity_fit.hpp), and all of them are turned
// such that the line of the cameras is horizontal. Horizontal shifts are chosen such that the focus stands still: what is as
// deep as the focus lies on the display. Pictures are cropped to what all of them show.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "align/parallax.hpp"
#include "align/similarity.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"

namespace lippmann {

struct AlignParams {
  std::filesystem::path in;         ///< a folder of pictures, in the natural order of their names from left to right
  std::filesystem::path out;        ///< a folder: view_000.png, view_001.png, ...
  std::optional<Vec2d> focus = {};  ///< pixels of the middle picture, from its top left; none: its centre
};

struct AlignedPicture {
  std::filesystem::path in, out;
  Similarity moved;          ///< from pixels of the picture to those of the middle one, as it was read
  double residual_px = 0.0;  ///< root mean square of the remaining vertical differences of places shared with others
};

struct AlignedPictures {
  std::vector<AlignedPicture> pictures;
  std::size_t middle = 0;
  Vec2i read_size{0};
  Vec2i corner{0}, size{0};  ///< the window that is kept
  Vec2d focus{0.0};          ///< pixels of every written picture
  Parallax parallax;
};

/// Reads folders as layout/picture_folder.hpp does, and writes codes as codes of as many bits. The result does not depend on
/// the number of threads. Warns if the focus is not seen in every picture. Throws Error naming the file or parameter.
AlignedPictures align_pictures(const AlignParams& params, const Context& context);

}  // namespace lippmann
