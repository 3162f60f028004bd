#include "align/similarity_fit.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/random.hpp"

namespace lippmann {
namespace {

/// Number of RANSAC samples of three matches. If a third of all matches are correct, the chance that no sample has three
/// correct matches is (1 - 1/27)^500, below 10^-8.
constexpr int kSamples = 500;
constexpr double kMaxTurn = 0.5, kMaxScale = 2.0;
constexpr int kRounds = 8;
constexpr double kSlopeSigma = 0.02;  ///< standard deviation of the slope: a slider holds a camera level to about a degree

/// Predicts the height b q.x + a q.y + y in the first image of a point q of the second image.
struct HeightRule {
  double b = 0.0, a = 1.0, y = 0.0;

  double error(Vec2d q, Vec2d p) const { return std::abs(b * q.x + a * q.y + y - p.y); }
  bool is_possible() const { return std::abs(b) < kMaxTurn && a < kMaxScale && a > 1.0 / kMaxScale; }
};

/// Returns the rule that fits three points exactly, or an impossible rule if they are collinear.
HeightRule rule_of(const std::array<Vec2d, 3>& q, const std::array<Vec2d, 3>& p) {
  const Vec2d u = q[1] - q[0], v = q[2] - q[0];
  const double du = p[1].y - p[0].y, dv = p[2].y - p[0].y, area = u.x * v.y - u.y * v.x;
  if (std::abs(area) < 1.0) return {.a = 0.0};
  HeightRule rule{(du * v.y - dv * u.y) / area, (u.x * dv - v.x * du) / area, 0.0};
  rule.y = p[0].y - rule.b * q[0].x - rule.a * q[0].y;
  return rule;
}

/// A symmetric matrix with leading zeros in its rows, solved by Cholesky factorisation, which preserves these zeros.
class EnvelopeMatrix {
 public:
  explicit EnvelopeMatrix(std::vector<std::size_t> begins) : begins_(std::move(begins)), rows_(begins_.size()) {
    for (std::size_t row = 0; row < rows_.size(); ++row) rows_[row].assign(row + 1 - begins_[row], 0.0);
  }

  double& at(std::size_t row, std::size_t column) {
    if (row < column) std::swap(row, column);
    return rows_[row][column - begins_[row]];
  }

  /// Returns the solution for the right-hand side `values`. Overwrites the matrix, which must be positive definite.
  std::vector<double> solve(std::vector<double> values) {
    factorise();
    const std::size_t count = rows_.size();
    for (std::size_t row = 0; row < count; ++row) {
      for (std::size_t column = begins_[row]; column < row; ++column) values[row] -= at(row, column) * values[column];
      values[row] /= at(row, row);
    }
    for (std::size_t row = count; row-- > 0;) {
      values[row] /= at(row, row);
      for (std::size_t column = begins_[row]; column < row; ++column) values[column] -= at(row, column) * values[row];
    }
    return values;
  }

 private:
  void factorise() {
    for (std::size_t row = 0; row < rows_.size(); ++row)
      for (std::size_t column = begins_[row]; column <= row; ++column) {
        double sum = at(row, column);
        for (std::size_t k = std::max(begins_[row], begins_[column]); k < column; ++k) sum -= at(row, k) * at(column, k);
        at(row, column) = row == column ? std::sqrt(sum) : sum / at(column, column);
      }
  }

  std::vector<std::size_t> begins_;
  std::vector<std::vector<double>> rows_;
};

/// The state of the fit. Lengths are in half diagonals of the images, and positions are measured from the centres of the
/// images.
class PictureFit {
 public:
  PictureFit(const std::vector<SharedPlaces>& shared, std::size_t count, std::size_t fixed, Vec2i size)
      : shared_(shared), fixed_(fixed), middle_(0.5 * Vec2d(size)), unit_px_(0.5 * glm::length(Vec2d(size))), rules_(count) {}

  void solve() {
    const double sigma = std::max(1.5 * median_error(), 0.01 / unit_px_);
    EnvelopeMatrix matrix(row_begins());
    std::vector<double> right(unknowns());
    matrix.at(slope_index(), slope_index()) = (sigma / kSlopeSigma) * (sigma / kSlopeSigma);
    for (const SharedPlaces& pair : shared_)
      for (std::size_t i = 0; i < pair.in_first.size(); ++i) {
        const double share = error_of(pair, i) / sigma;
        add_equation(pair, i, 1.0 / (1.0 + share * share), matrix, right);
      }
    const std::vector<double> found = matrix.solve(std::move(right));
    for (std::size_t picture = 0; picture < rules_.size(); ++picture)
      if (picture != fixed_) {
        const std::size_t at = index_of(picture);
        rules_[picture] = {found[at], found[at + 1], found[at + 2]};
      }
    slope_ = found[slope_index()];
  }

  FittedPictures result() const {
    FittedPictures fitted;
    fitted.slope = slope_;
    for (const HeightRule& rule : rules_) {
      Similarity picture{rule.a, rule.b, 0.0, 0.0};
      const Vec2d moved = middle_ + Vec2d(0.0, rule.y * unit_px_) - picture(middle_);
      picture.x = moved.x, picture.y = moved.y;
      fitted.pictures.push_back(picture);
    }
    fitted.residuals = residuals();
    return fitted;
  }

 private:
  std::size_t unknowns() const { return 3 * rules_.size() - 2; }
  std::size_t slope_index() const { return unknowns() - 1; }
  /// Returns the index of the unknown b of an image; the unknowns a and y follow it. The fixed image has no unknowns.
  std::size_t index_of(std::size_t picture) const { return 3 * (picture < fixed_ ? picture : picture - 1); }

  std::vector<std::size_t> row_begins() const {
    std::vector<std::size_t> begins(unknowns(), 0);
    for (std::size_t row = 0; row < slope_index(); ++row) begins[row] = row / 3 * 3;
    for (const SharedPlaces& pair : shared_) {
      if (pair.first == fixed_ || pair.second == fixed_) continue;
      const std::size_t first = index_of(pair.first), second = index_of(pair.second);
      const std::size_t low = std::min(first, second), high = std::max(first, second);
      for (std::size_t row = high; row < high + 3; ++row) begins[row] = std::min(begins[row], low);
    }
    return begins;
  }

  Vec2d centred(Vec2d place) const { return (place - middle_) / unit_px_; }
  double height(std::size_t picture, Vec2d place) const {
    return rules_[picture].b * place.x + rules_[picture].a * place.y + rules_[picture].y;
  }
  double side(std::size_t picture, Vec2d place) const { return rules_[picture].a * place.x - rules_[picture].b * place.y; }

  double error_of(const SharedPlaces& pair, std::size_t i) const {
    const Vec2d first = centred(pair.in_first[i]), second = centred(pair.in_second[i]);
    return height(pair.first, first) - height(pair.second, second) -
           slope_ * (side(pair.first, first) - side(pair.second, second));
  }

  double median_error() const {
    std::vector<double> errors;
    for (const SharedPlaces& pair : shared_)
      for (std::size_t i = 0; i < pair.in_first.size(); ++i) errors.push_back(std::abs(error_of(pair, i)));
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return *middle;
  }

  /// Adds the equation height(first) - height(second) - slope * (side(first) - side(second)) = 0. `side` is the horizontal
  /// position, computed with the transforms of the last round.
  void add_equation(const SharedPlaces& pair, std::size_t i, double weight, EnvelopeMatrix& matrix,
                    std::vector<double>& right) const {
    std::array<std::pair<std::size_t, double>, 7> terms{};
    std::size_t count = 0;
    double value = 0.0;
    const auto add_picture = [&](std::size_t picture, Vec2d place, double sign) {
      if (picture == fixed_) {
        value -= sign * place.y;
        return;
      }
      const std::size_t at = index_of(picture);
      terms[count++] = {at, sign * place.x}, terms[count++] = {at + 1, sign * place.y}, terms[count++] = {at + 2, sign};
    };
    const Vec2d first = centred(pair.in_first[i]), second = centred(pair.in_second[i]);
    add_picture(pair.first, first, 1.0);
    add_picture(pair.second, second, -1.0);
    terms[count++] = {slope_index(), side(pair.second, second) - side(pair.first, first)};
    for (std::size_t row = 0; row < count; ++row) {
      right[terms[row].first] += weight * terms[row].second * value;
      for (std::size_t column = 0; column < count; ++column)
        if (terms[column].first <= terms[row].first)
          matrix.at(terms[row].first, terms[column].first) += weight * terms[row].second * terms[column].second;
    }
  }

  std::vector<double> residuals() const {
    std::vector<double> squares(rules_.size(), 0.0), counts(rules_.size(), 0.0);
    for (const SharedPlaces& pair : shared_)
      for (std::size_t i = 0; i < pair.in_first.size(); ++i)
        for (const std::size_t picture : {pair.first, pair.second}) {
          const double error = error_of(pair, i) * unit_px_;
          squares[picture] += error * error, counts[picture] += 1.0;
        }
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = std::sqrt(squares[i] / std::max(counts[i], 1.0));
    return squares;
  }

  const std::vector<SharedPlaces>& shared_;
  std::size_t fixed_;
  Vec2d middle_;
  double unit_px_;
  std::vector<HeightRule> rules_;
  double slope_ = 0.0;
};

}  // namespace

void keep_consistent(SharedPlaces& shared, double tolerance) {
  const auto count = static_cast<std::uint32_t>(shared.in_first.size());
  HeightRule best;
  std::size_t most = 0;
  for (std::uint32_t sample = 0; count >= 3 && sample < kSamples; ++sample) {
    std::array<Vec2d, 3> q{}, p{};
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t chosen = hash(sample, i, 7) % count;
      q[i] = shared.in_second[chosen], p[i] = shared.in_first[chosen];
    }
    const HeightRule rule = rule_of(q, p);
    if (!rule.is_possible()) continue;
    std::size_t agree = 0;
    for (std::size_t i = 0; i < count; ++i) agree += rule.error(shared.in_second[i], shared.in_first[i]) <= tolerance ? 1 : 0;
    if (agree > most) most = agree, best = rule;
  }
  SharedPlaces kept{shared.first, shared.second, {}, {}};
  for (std::size_t i = 0; most > 0 && i < count; ++i)
    if (best.error(shared.in_second[i], shared.in_first[i]) <= tolerance) {
      kept.in_first.push_back(shared.in_first[i]);
      kept.in_second.push_back(shared.in_second[i]);
    }
  shared = std::move(kept);
}

FittedPictures fit_pictures(const std::vector<SharedPlaces>& shared, std::size_t count, std::size_t fixed, Vec2i size) {
  PictureFit fit(shared, count, fixed, size);
  for (int round = 0; round < kRounds; ++round) fit.solve();
  return fit.result();
}

}  // namespace lippmann
