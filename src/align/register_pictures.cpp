#include "align/register_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "align/align_module.hpp"
#include "align/parallax.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr int kLongestPx = 1600;    ///< longer side of the compared images; noise and blur hide finer detail
constexpr int kMaxFeatures = 2500;  ///< maximum number of features per image; matching time is quadratic in it
constexpr int kMaxReaders = 8;
/// Largest vertical mismatch of a point in neighbouring images, relative to their longer side.
constexpr double kTolerance = 2e-3;
constexpr std::size_t kMinPlaces = 20;

std::vector<Features> features_of(const std::vector<fs::path>& files, RegisteredPictures& result, int threads,
                                  const Context& context) {
  const AlignModule& module = align_module();
  std::vector<Features> features(files.size());
  result.greys.resize(files.size());
  const ThreadPool readers(std::min(threads, kMaxReaders));
  std::vector<Vec2i> sizes(files.size());
  readers.for_each(files.size(), [&](std::size_t i) {
    if (context.cancelled) return;
    const Picture picture = read_picture(files[i], context.warn);
    sizes[i] = std::visit([](const auto& image) { return Vec2i(image.width, image.height); }, picture);
    result.greys[i] = grey_of(picture, kLongestPx);
    features[i] = module.features(result.greys[i], kMaxFeatures);
  });
  result.size = sizes.front();
  return features;
}

std::vector<SharedPlaces> compared_pairs(std::size_t count, std::size_t middle) {
  std::vector<SharedPlaces> pairs;
  for (std::size_t i = 0; i + 1 < count; ++i) pairs.push_back({i, i + 1, {}, {}});
  for (std::size_t i = 0; i < count; ++i)
    if (i + 1 < middle || i > middle + 1) pairs.push_back({i, middle, {}, {}});
  return pairs;
}

void find_shared(SharedPlaces& pair, const std::vector<Features>& features, Vec2d pixels_per_grey) {
  const Features &first = features[pair.first], &second = features[pair.second];
  for (const FeatureMatch& match : align_module().matches(first, second)) {
    pair.in_first.push_back(Vec2d(first.places[match.first]) * pixels_per_grey);
    pair.in_second.push_back(Vec2d(second.places[match.second]) * pixels_per_grey);
  }
}

void require_places(const SharedPlaces& pair, const std::vector<fs::path>& files) {
  if (pair.in_first.size() >= kMinPlaces) return;
  throw Error(files[pair.second].string(),
              fmt::format("shares only {} points with {}, too few to align them", pair.in_first.size(),
                          files[pair.first].filename().string()),
              fmt::format("{} or more: pictures of one scene with texture, in the order of their cameras", kMinPlaces));
}

/// Rotates all images about the centre of the middle one until the line of the cameras is horizontal, unless the rotation would
/// have no visible effect.
void level(RegisteredPictures& registered, double slope) {
  constexpr double kVisiblePx = 0.1;
  if (std::abs(slope) * parallax_of(registered).total_px() < kVisiblePx) return;
  const double length = std::hypot(1.0, slope);
  Similarity turn{1.0 / length, -slope / length, 0.0, 0.0};
  const Vec2d centre = 0.5 * Vec2d(registered.size), moved = centre - turn(centre);
  turn.x = moved.x, turn.y = moved.y;
  for (Similarity& picture : registered.pictures) picture = turn * picture;
}

}  // namespace

RegisteredPictures register_pictures(const std::vector<fs::path>& files, const ThreadPool& pool, const Context& context) {
  RegisteredPictures result;
  result.middle = files.size() / 2;
  const std::vector<Features> features = features_of(files, result, pool.threads(), context);
  if (context.cancelled) return result;
  const GreyPicture& grey = result.greys.front();
  const Vec2d pixels_per_grey = Vec2d(result.size) / Vec2d(grey.width, grey.height);
  result.shared = compared_pairs(files.size(), result.middle);
  pool.for_each(result.shared.size(), [&](std::size_t i) {
    find_shared(result.shared[i], features, pixels_per_grey);
    keep_consistent(result.shared[i], kTolerance * std::max(result.size.x, result.size.y));
  });
  for (std::size_t i = 0; i + 1 < files.size(); ++i) require_places(result.shared[i], files);
  std::erase_if(result.shared, [](const SharedPlaces& pair) { return pair.in_first.size() < kMinPlaces; });
  FittedPictures fitted = fit_pictures(result.shared, files.size(), result.middle, result.size);
  result.pictures = std::move(fitted.pictures), result.residuals = std::move(fitted.residuals);
  level(result, fitted.slope);
  return result;
}

}  // namespace lippmann
