#include "align/focus_shift.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lippmann {
namespace {

constexpr std::size_t kNearPlaces = 15;
constexpr int kSearchPx = 3;
constexpr int kRefinements = 12;
constexpr double kMinLikeness = 0.7;  ///< smallest correlation of two patches that are taken to show the same point
constexpr double kMinContrast = 2.0;  ///< smallest standard deviation of a patch that can be found again, in 8-bit grey codes

struct Patch {
  std::vector<double> values;
  double contrast = 0.0;
};

double correlation(const Patch& a, const Patch& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) sum += a.values[i] * b.values[i];
  return sum / static_cast<double>(a.values.size());
}

double code_at(const GreyPicture& grey, Vec2d place) {
  const Vec2d corner = glm::clamp(place - 0.5, Vec2d(0.0), Vec2d(grey.width, grey.height) - 1.0);
  const Vec2i low = glm::min(Vec2i(corner), Vec2i(grey.width, grey.height) - 2);
  const Vec2d share = corner - Vec2d(low);
  const auto code = [&](int x, int y) {
    return static_cast<double>(grey.codes[static_cast<std::size_t>(low.y + y) * grey.width + low.x + x]);
  };
  return (1.0 - share.y) * ((1.0 - share.x) * code(0, 0) + share.x * code(1, 0)) +
         share.y * ((1.0 - share.x) * code(0, 1) + share.x * code(1, 1));
}

class FocusSearch {
 public:
  FocusSearch(const RegisteredPictures& registered, Vec2d focus)
      : registered_(registered), place_(registered.pictures[registered.middle](focus)) {
    const GreyPicture& grey = registered.greys.front();
    pixels_per_grey_ = static_cast<double>(registered.size.x) / grey.width;
    half_ = std::clamp(std::max(grey.width, grey.height) / 80, 5, 16);
    wanted_ = patch(registered.middle, 0.0);
  }

  bool has_texture() const { return wanted_.contrast >= kMinContrast; }

  /// Returns the x of the focus point in `picture` minus its x in the middle image, in pixels. `from` is the neighbouring image
  /// nearer to the middle, and `known` is the result for `from`. Sets `guess` to an estimate from the motion of shared points.
  /// Returns nullopt if no patch matches.
  std::optional<double> find(std::size_t picture, std::size_t from, double known, double& guess) const {
    const std::vector<double> steps = near_steps(picture, from, known);
    guess = known + steps[steps.size() / 2];
    double best = guess, likeness = -1.0;
    for (const double step : steps)
      for (int move = -kSearchPx; move <= kSearchPx; ++move) {
        const double offset = known + step + move * pixels_per_grey_;
        if (const double found = correlation(wanted_, patch(picture, offset)); found > likeness)
          likeness = found, best = offset;
      }
    if (!has_texture() || likeness < kMinLikeness) return std::nullopt;
    return refined(picture, best);
  }

 private:
  std::vector<double> near_steps(std::size_t picture, std::size_t from, double known) const {
    const auto pair = std::find_if(registered_.shared.begin(), registered_.shared.end(), [&](const SharedPlaces& shared) {
      return shared.first == std::min(picture, from) && shared.second == std::max(picture, from);
    });
    struct Step {
      double distance, move;
    };
    std::vector<Step> steps;
    for (std::size_t i = 0; i < pair->in_first.size(); ++i) {
      const Vec2d first = registered_.pictures[pair->first](pair->in_first[i]),
                  second = registered_.pictures[pair->second](pair->in_second[i]);
      const Vec2d &here = picture < from ? first : second, &there = picture < from ? second : first;
      steps.push_back({glm::length(there - place_ - Vec2d(known, 0.0)), here.x - there.x});
    }
    const std::size_t count = std::min(kNearPlaces, steps.size());
    std::partial_sort(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(count), steps.end(),
                      [](const Step& a, const Step& b) { return a.distance < b.distance; });
    std::vector<double> moves;
    for (std::size_t i = 0; i < count; ++i) moves.push_back(steps[i].move);
    std::sort(moves.begin(), moves.end());
    return moves;
  }

  Patch patch(std::size_t picture, double offset) const {
    const Similarity back = inverse(registered_.pictures[picture]);
    const GreyPicture& grey = registered_.greys[picture];
    const Vec2d grey_per_pixel = Vec2d(grey.width, grey.height) / Vec2d(registered_.size);
    Patch patch;
    double sum = 0.0, squares = 0.0;
    for (int y = -half_; y <= half_; ++y)
      for (int x = -half_; x <= half_; ++x) {
        const Vec2d place = place_ + Vec2d(offset, 0.0) + pixels_per_grey_ * Vec2d(x, y);
        const double code = code_at(grey, back(place) * grey_per_pixel);
        patch.values.push_back(code);
        sum += code, squares += code * code;
      }
    const double count = static_cast<double>(patch.values.size()), mean = sum / count;
    patch.contrast = std::sqrt(std::max(squares / count - mean * mean, 0.0));
    for (double& value : patch.values) value = (value - mean) / std::max(patch.contrast, 1e-6);
    return patch;
  }

  /// Refines an offset by Gauss-Newton steps, which minimise the difference of the patches along the row.
  double refined(std::size_t picture, double offset) const {
    const double step = 0.5 * pixels_per_grey_, begin = offset;
    for (int round = 0; round < kRefinements; ++round) {
      const Patch here = patch(picture, offset), left = patch(picture, offset - step), right = patch(picture, offset + step);
      double product = 0.0, square = 0.0;
      for (std::size_t i = 0; i < here.values.size(); ++i) {
        const double slope = right.values[i] - left.values[i];
        product += slope * (wanted_.values[i] - here.values[i]), square += slope * slope;
      }
      offset += std::clamp(product / std::max(square, 1e-9), -1.0, 1.0) * 2.0 * step;
    }
    return std::abs(offset - begin) <= 1.5 * pixels_per_grey_ ? offset : begin;
  }

  const RegisteredPictures& registered_;
  Vec2d place_;
  double pixels_per_grey_ = 1.0;
  int half_ = 0;
  Patch wanted_;
};

}  // namespace

FocusShifts focus_shifts(const RegisteredPictures& registered, Vec2d focus) {
  const FocusSearch search(registered, focus);
  FocusShifts result{std::vector<double>(registered.pictures.size(), 0.0)};
  const auto follow = [&](std::size_t picture, std::size_t from) {
    double guess = 0.0;
    const std::optional<double> found = search.find(picture, from, -result.shifts[from], guess);
    if (!found) ++result.unseen;
    result.shifts[picture] = -found.value_or(guess);
  };
  for (std::size_t i = registered.middle; i-- > 0;) follow(i, i + 1);
  for (std::size_t i = registered.middle + 1; i < registered.pictures.size(); ++i) follow(i, i - 1);
  return result;
}

}  // namespace lippmann
