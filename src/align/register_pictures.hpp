// Finds places that pictures of a row of cameras share, and how the pictures are turned, scaled and shifted up or down.
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
  Vec2i size{0};                     ///< pixels of each picture
  std::size_t middle = 0;            ///< the picture that the others are registered to
  std::vector<GreyPicture> greys;    ///< pictures of at most 1600 pixels a side
  std::vector<SharedPlaces> shared;  ///< of neighbours (picture i and i + 1), then of pictures (first) and the middle one
  std::vector<Similarity> pictures;  ///< aligns rows: the line of the cameras is horizontal; x is 0 at the centre
  std::vector<double> residuals;     ///< root mean square of the remaining vertical differences, pixels
};

/// `files`: two or more pictures of one size. Throws Error naming two neighbours that share too few places. The result does not
/// depend on the number of threads.
RegisteredPictures register_pictures(const std::vector<std::filesystem::path>& files, const ThreadPool& pool,
                                     const Context& context);

}  // namespace lippmann
