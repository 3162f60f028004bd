// Finds points shared by images of a row of cameras, and the rotation, scale and vertical shift of each image.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "align/grey_picture.hpp"
#include "align/similarity.hpp"
#include "align/similarity_fit.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {

struct RegisteredPictures {
  Vec2i size{0};                   ///< size of each image, in pixels
  std::size_t middle = 0;          ///< index of the image to which all others are registered
  std::vector<GreyPicture> greys;  ///< the images as grey images with at most 1600 pixels a side
  /// Points shared by neighbours (images i and i + 1), then points shared by an image (first) and the middle one.
  std::vector<SharedPlaces> shared;
  /// Transforms that align the rows of the images and make the line of the cameras horizontal. Horizontal shifts are not
  /// fitted.
  std::vector<Similarity> pictures;
  std::vector<double> residuals;  ///< root mean square of the vertical differences that remain after alignment, in pixels
};

/// Registers two or more images of one size. Throws Error naming two neighbours with too few shared points. The result does not
/// depend on the number of threads.
RegisteredPictures register_pictures(const std::vector<std::filesystem::path>& files, const ThreadPool& pool,
                                     const Context& context);

}  // namespace lippmann
