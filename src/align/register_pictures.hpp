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
  Vec2i size{0};
  std::size_t middle = 0;
  std::vector<GreyPicture> greys;
  /// The points that images i and i + 1 share, for each i. Then the points that other images share with the middle image.
  std::vector<SharedPlaces> shared;
  /// Transforms that align the rows of the images and make the line of the cameras horizontal.
  std::vector<Similarity> pictures;
  std::vector<double> residuals;
};

/// Registers two or more images of one size. Throws Error naming two neighbours with too few shared points.
RegisteredPictures register_pictures(const std::vector<std::filesystem::path>& files, const ThreadPool& pool,
                                     const Context& context);

}  // namespace lippmann
