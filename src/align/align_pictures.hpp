// Aligns images that were shot by hand or on a slider, so that they can serve as the views of a row of cameras.
//
// Each image is rotated, scaled and shifted vertically so that shared points have equal heights (align/similarity_fit.hpp).
// Then all images are rotated together to make the line of the cameras horizontal. Horizontal shifts keep the focus point
// still, so that points at its depth are shown in the plane of the display. The images are cropped to their common area.
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
  std::filesystem::path in;  ///< a folder of images; the natural order of their names is the order from left to right
  std::filesystem::path out;
  /// The focus point in pixels of the middle image, from its top left; none: the centre of that image.
  std::optional<Vec2d> focus = {};
};

struct AlignedPicture {
  std::filesystem::path in, out;
  Similarity moved;  ///< transform from pixels of the image to pixels of the uncropped middle image
  double residual_px = 0.0;
};

struct AlignedPictures {
  std::vector<AlignedPicture> pictures;
  std::size_t middle = 0;
  Vec2i read_size{0};
  Vec2i corner{0}, size{0};
  Vec2d focus{0.0};
  Parallax parallax;
};

/// Aligns the images of a folder (see formats/picture_folder.hpp). Integer samples keep their number of bits. Warns if the
/// focus is not visible in every image. Throws Error naming the file or parameter.
AlignedPictures align_pictures(const AlignParams& params, const Context& context);

}  // namespace lippmann
