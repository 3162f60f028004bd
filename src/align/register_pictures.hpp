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
  Vec2i size{0};                     ///< pixels of each image
  std::size_t middle = 0;            ///< the image that the others are registered to
  std::vector<GreyPicture> greys;    ///< images of at most 1600 pixels a side
  std::vector<SharedPlaces> shared;  ///< of neighbours (image i and i + 1), then of images (first) and the middle one
  std::vector<Similarity> pictures;  ///< align rows: the line of the cameras is horizontal; x is 0 at the centre
  std::vector<double> residuals;     ///< root mean square of the remaining vertical differences, pixels
};

/// Registers two or more images of one size. Throws Error naming two neighbours with too few shared points. The result does not
/// depend on the number of threads.
RegisteredPictures register_pictures(const std::vector<std::filesystem::path>& files, const ThreadPool& pool,
                                     const Context& context);

}  // namespace lippmann
