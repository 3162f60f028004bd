#include "denoise/filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "core/multiversion.hpp"

namespace lippmann {
namespace {

// Standard deviations of the Gaussian weights that compare two surfaces. docs/lab/decisions/0013 has the measurements behind
// them.
constexpr float kNormalSpread = 0.2f;  ///< length of the difference between two unit normals
constexpr float kAlbedoSpread = 0.2f;
constexpr float kMetSpread = 0.2f;
/// Distance of a point from the plane of the surface, in units of the distance between neighbouring samples.
constexpr float kPlaneSpread = 3.0f;
constexpr float kRelativeSpread = 0.01f;

constexpr int kViewReach = 3;  ///< number of views searched to the left, to the right, up and down

// Thresholds of the test for fireflies (find_outliers()).
/// Minimum ratio of noise to light. The noise is half the difference between the two halves of the samples, and the light is
/// their mean. At a ratio of 0.4, one half has 70 % of the light: (0.7 - 0.3) / (0.7 + 0.3) = 0.4.
constexpr float kOneHalf = 0.4f;
constexpr float kBrighter = 2.0f;  ///< minimum ratio of the pixel's light to the light of its second-brightest neighbour
constexpr float kSameMaterial = 4.0f;
constexpr float kLeastNeighbours = 8.0f;

/// A neighbour gets a lower weight if its variance exceeds the pixel's variance by more than this factor. Otherwise the noisy
/// edge of a highlight would spread into its surroundings.
constexpr float kInfluence = 16.0f;

/// If the filter's squared change of light is below this fraction of the estimated variance, the change counts as removed
/// noise. The estimated variance is about twice the true variance (NoisyFrame::noise).
constexpr float kExplained = 0.7f;

constexpr float kNoNoise = 1e-10f;

constexpr int kColumns = 128, kMargin = 8, kRow = kColumns + 2 * kMargin;
constexpr int kRowsPerPiece = 16;

struct alignas(64) SurfaceRow {
  float x[kRow], y[kRow], z[kRow];
  float normal_x[kRow], normal_y[kRow], normal_z[kRow];
  float red[kRow], green[kRow], blue[kRow];
  float met[kRow];
  float there[kRow];  ///< 1 if the pixel shows a surface; 0 if not, and then the other arrays are undefined
};

struct alignas(64) LightRow {
  float red[kRow], green[kRow], blue[kRow], variance[kRow];
};

struct TexelRow {
  SurfaceRow surface{};
  LightRow light{};
};

LIPPMANN_INLINE void set_surface(const Texels& texels, std::size_t p, int i, SurfaceRow& row) {
  row.x[i] = texels.place[3 * p], row.y[i] = texels.place[3 * p + 1], row.z[i] = texels.z[p];
  row.normal_x[i] = texels.normal[3 * p], row.normal_y[i] = texels.normal[3 * p + 1],
  row.normal_z[i] = texels.normal[3 * p + 2];
  row.red[i] = texels.albedo[3 * p], row.green[i] = texels.albedo[3 * p + 1], row.blue[i] = texels.albedo[3 * p + 2];
  row.met[i] = texels.met[p];
}

LIPPMANN_INLINE void set_light(const float* light, float variance, int i, LightRow& row) {
  row.red[i] = light[0], row.green[i] = light[1], row.blue[i] = light[2], row.variance[i] = variance;
}

void set_light(const Estimate& estimate, int i, LightRow& row) { set_light(&estimate.light.x, estimate.variance, i, row); }

/// A rectangle of a view that one task processes. Its first column is `column` and its first row is `row`. Rows are `stride`
/// rows apart.
struct Piece {
  int view, column, columns, row, rows, stride;
};

template <class Fn>
void for_each_piece(const SortedViews& views, int stride, const ThreadPool& pool, const Fn& fn) {
  const Vec2i size = views.size();
  const int across = (size.x + kColumns - 1) / kColumns;
  const int in_class = (size.y + stride - 1) / stride, parts = (in_class + kRowsPerPiece - 1) / kRowsPerPiece;
  const auto pieces = static_cast<std::size_t>(views.views()) * static_cast<std::size_t>(across * stride * parts);
  pool.for_each(pieces, [&](std::size_t index) {
    // Consecutive pieces belong to different views. The film of a lens array stores pixels of different views side by side, so
    // these pieces read neighbouring memory.
    const int view = static_cast<int>(index % static_cast<std::size_t>(views.views()));
    const int in_view = static_cast<int>(index / static_cast<std::size_t>(views.views()));
    const int column = in_view % across * kColumns, part = in_view / across;
    const int first = part % stride + part / stride * kRowsPerPiece * stride;
    const int rows = std::min(kRowsPerPiece, (size.y - first + stride - 1) / stride);
    if (rows > 0) fn(Piece{view, column, std::min(kColumns, size.x - column), first, rows, stride});
  });
}

/// The `kHeight` rows of a view around the current row. If around() is called from top to bottom, each row is loaded only once.
template <int kHeight, class Row>
class RowWindow {
 public:
  RowWindow(const SortedViews& views, const Piece& piece) : views_(views), piece_(piece) { loaded_.fill(-1); }

  /// Returns the rows around row y. Entry d + kHeight / 2 is row y + d stride, or null if that row lies outside the view.
  /// load(pixel, i, row) copies a pixel to column i of the row; it is called for each pixel that shows a surface.
  template <class Load>
  const std::array<const Row*, kHeight>& around(int y, int margin, const float* met, const Load& load) {
    for (int d = -kHeight / 2; d <= kHeight / 2; ++d) {
      const int from = y + d * piece_.stride;
      auto& row = around_[static_cast<std::size_t>(d + kHeight / 2)];
      row = nullptr;
      if (from < 0 || from >= views_.size().y) continue;
      const auto slot = static_cast<std::size_t>(from / piece_.stride % kHeight);
      row = &(*rows_)[slot];
      if (std::exchange(loaded_[slot], from) != from) read(from, margin, met, load, (*rows_)[slot]);
    }
    return around_;
  }

 private:
  template <class Load>
  void read(int y, int margin, const float* met, const Load& load, Row& row) const {
    const std::uint32_t* pixels = views_.row(piece_.view, y);
    for (int x = piece_.column - margin; x < piece_.column + piece_.columns + margin; ++x) {
      const int i = x - piece_.column + kMargin;
      const std::uint32_t p = x >= 0 && x < views_.size().x ? pixels[x] : SortedViews::kNoPixel;
      const bool there = p != SortedViews::kNoPixel && met[p] > 0.0f;
      row.surface.there[i] = there ? 1.0f : 0.0f;
      if (there) load(p, i, row);
    }
  }

  const SortedViews& views_;
  Piece piece_;
  std::unique_ptr<std::array<Row, kHeight>> rows_ = std::make_unique<std::array<Row, kHeight>>();
  std::array<int, kHeight> loaded_;
  std::array<const Row*, kHeight> around_;
};

template <class Fn>
void for_each_row(const SortedViews& views, const Piece& piece, const float* met, const Fn& fn) {
  for (int row = 0; row < piece.rows; ++row) {
    const int y = piece.row + row * piece.stride;
    const std::uint32_t* pixels = views.row(piece.view, y) + piece.column;
    if (std::any_of(pixels, pixels + piece.columns,
                    [met](std::uint32_t p) { return p != SortedViews::kNoPixel && met[p] > 0.0f; }))
      fn(y);
  }
}

template <class Fn>
void for_each_pixel(const SortedViews& views, const Piece& piece, int y, const float* met, const Fn& fn) {
  const std::uint32_t* pixels = views.row(piece.view, y) + piece.column;
  for (int i = 0; i < piece.columns; ++i)
    if (pixels[i] != SortedViews::kNoPixel && met[pixels[i]] > 0.0f) fn(pixels[i], i);
}

/// Rounds a number of columns up to a multiple of 16, the number of floats in an AVX-512 vector. Results for the added columns
/// are not used.
int whole_lanes(int columns) { return (columns + 15) / 16 * 16; }

#define LIPPMANN_FOR_COLUMNS(i, count) _Pragma("GCC ivdep") for (int i = 0; i < (count); ++i)

LIPPMANN_INLINE float square(float x) { return x * x; }
LIPPMANN_INLINE float squares(float x, float y, float z) { return x * x + y * y + z * z; }
constexpr float inverse_square(float x) { return 1.0f / (x * x); }
LIPPMANN_INLINE float least(float a, float b) { return a < b ? a : b; }
LIPPMANN_INLINE float most(float a, float b) { return a > b ? a : b; }

LIPPMANN_INLINE float material_difference(const SurfaceRow& a, int i, const SurfaceRow& b, int j) {
  return squares(a.normal_x[i] - b.normal_x[j], a.normal_y[i] - b.normal_y[j], a.normal_z[i] - b.normal_z[j]) *
             inverse_square(kNormalSpread) +
         squares(a.red[i] - b.red[j], a.green[i] - b.green[j], a.blue[i] - b.blue[j]) * inverse_square(kAlbedoSpread) +
         square(a.met[i] - b.met[j]) * inverse_square(kMetSpread);
}

LIPPMANN_INLINE float light_difference(const LightRow& a, int i, const LightRow& b, int j) {
  const float variance = a.variance[i] + b.variance[j];
  const float visible =
      square(kRelativeSpread) * (squares(a.red[i], a.green[i], a.blue[i]) + squares(b.red[j], b.green[j], b.blue[j])) +
      kNoNoise;
  const float difference = squares(a.red[i] - b.red[j], a.green[i] - b.green[j], a.blue[i] - b.blue[j]) - variance;
  return most(difference, 0.0f) / (variance + visible);
}

/// Returns a factor from 0 to 1 for the weight of a neighbour, below 1 if the neighbour is much noisier than the pixel (see
/// kInfluence).
LIPPMANN_INLINE float influence(float variance, float of_other) {
  return least(1.0f, kInfluence * (variance + kNoNoise) / (of_other + kNoNoise));
}

/// Approximates exp(-difference / 2) by (1 - difference / 128)^64, which vectorises well.
LIPPMANN_INLINE float weight_of(float difference) {
  float power = most(1.0f - difference * (1.0f / 128), 0.0f);
  for (int doubling = 0; doubling < 6; ++doubling) power *= power;
  return power;
}

/// Scaled normals of the points of a row. The dot product of a normal with the offset to another point is the distance of that
/// point from the surface's tangent plane, in units of kPlaneSpread sample distances.
struct alignas(64) PlaneRow {
  float x[kColumns], y[kColumns], z[kColumns];
};

LIPPMANN_INLINE void make_planes(const SurfaceRow& a, float distance_mm, float vergence, int count, PlaneRow& planes) {
  LIPPMANN_FOR_COLUMNS(i, count) {
    const int j = i + kMargin;
    const float length = std::sqrt(squares(a.normal_x[j], a.normal_y[j], a.normal_z[j]));
    const float spread = kPlaneSpread * distance_mm * std::abs(1.0f - a.z[j] * vergence) + 1e-6f;
    const float scale = 1.0f / (most(length, 1e-6f) * spread);
    planes.x[i] = a.normal_x[j] * scale, planes.y[i] = a.normal_y[j] * scale, planes.z[i] = a.normal_z[j] * scale;
  }
}

LIPPMANN_INLINE float plane_difference(const PlaneRow& planes, const SurfaceRow& a, int i, const SurfaceRow& b, int j) {
  const int at = i + kMargin;
  return square(planes.x[i] * (b.x[j] - a.x[at]) + planes.y[i] * (b.y[j] - a.y[at]) + planes.z[i] * (b.z[j] - a.z[at]));
}

/// Weighted sums over the neighbours of each pixel of a row. mean() divides them by the sum of the weights.
struct alignas(64) SumRow {
  float red[kColumns], green[kColumns], blue[kColumns], variance[kColumns], weight[kColumns], squares[kColumns];

  Estimate mean(int i) const {
    const float over = 1.0f / weight[i];
    return {{red[i] * over, green[i] * over, blue[i] * over}, variance[i] * over * over};
  }
};

LIPPMANN_INLINE void clear(SumRow& sums, int count) {
  LIPPMANN_FOR_COLUMNS(i, count) {
    sums.red[i] = sums.green[i] = sums.blue[i] = sums.variance[i] = sums.weight[i] = sums.squares[i] = 0.0f;
  }
}

LIPPMANN_INLINE void add(const LightRow& light, int j, float weight, SumRow& sums, int i) {
  sums.red[i] += weight * light.red[j], sums.green[i] += weight * light.green[j], sums.blue[i] += weight * light.blue[j];
  sums.variance[i] += weight * weight * light.variance[j];
  sums.weight[i] += weight;
}

using RowsOfFive = std::array<const TexelRow*, kNeighbours>;
using RowsOfSeven = std::array<const TexelRow*, 7>;
static_assert(2 * kOutlierReach + 1 == 7 && 2 * kBlurReach + 1 == 7 && 2 * kGuideReach + 1 == kNeighbours);

/// The squared light of the two brightest neighbours of each pixel, among neighbours within 7 x 7 pixels and of the same
/// material.
struct alignas(64) BrightRow {
  float brightest[kColumns], second[kColumns], neighbours[kColumns];
};

LIPPMANN_MULTIVERSION
void find_brightest(const RowsOfSeven& rows, int count, BrightRow& found) {
  LIPPMANN_FOR_COLUMNS(i, count) found.brightest[i] = found.second[i] = found.neighbours[i] = 0.0f;
  const SurfaceRow& a = rows[kOutlierReach]->surface;
  for (int dj = -kOutlierReach; dj <= kOutlierReach; ++dj) {
    const TexelRow* b = rows[static_cast<std::size_t>(dj + kOutlierReach)];
    for (int di = -kOutlierReach; b && di <= kOutlierReach; ++di) {
      if (di == 0 && dj == 0) continue;
      LIPPMANN_FOR_COLUMNS(i, count) {
        const int j = i + kMargin + di;
        const float same = material_difference(a, i + kMargin, b->surface, j) < kSameMaterial ? b->surface.there[j] : 0.0f;
        const float light = same * squares(b->light.red[j], b->light.green[j], b->light.blue[j]);
        found.second[i] = most(found.second[i], least(found.brightest[i], light));
        found.brightest[i] = most(found.brightest[i], light);
        found.neighbours[i] += same;
      }
    }
  }
}

LIPPMANN_MULTIVERSION
void pool_neighbours(const RowsOfFive& rows, float distance_mm, float vergence, int count, SumRow& sums) {
  const SurfaceRow& a = rows[kGuideReach]->surface;
  PlaneRow planes;
  make_planes(a, distance_mm * kGuideReach, vergence, count, planes);
  clear(sums, count);
  for (int dj = -kGuideReach; dj <= kGuideReach; ++dj) {
    const TexelRow* b = rows[static_cast<std::size_t>(dj + kGuideReach)];
    for (int di = -kGuideReach; b && di <= kGuideReach; ++di) LIPPMANN_FOR_COLUMNS(i, count) {
        const int j = i + kMargin + di;
        const float weight = b->surface.there[j] * weight_of(material_difference(a, i + kMargin, b->surface, j) +
                                                             plane_difference(planes, a, i, b->surface, j));
        sums.red[i] += weight * b->light.red[j], sums.green[i] += weight * b->light.green[j];
        sums.blue[i] += weight * b->light.blue[j], sums.variance[i] += weight * b->light.variance[j];
        sums.weight[i] += weight, sums.squares[i] += weight * weight;
      }
  }
}

LIPPMANN_MULTIVERSION
void smooth_row(const RowsOfFive& rows, int step, float distance_mm, float vergence, int count, SumRow& sums) {
  constexpr std::array<float, kNeighbours> kSpline{1.0f / 16, 1.0f / 4, 3.0f / 8, 1.0f / 4, 1.0f / 16};
  const TexelRow& a = *rows[kNeighbours / 2];
  PlaneRow planes;
  make_planes(a.surface, distance_mm * static_cast<float>(step), vergence, count, planes);
  clear(sums, count);
  for (std::size_t dj = 0; dj < kNeighbours; ++dj) {
    const TexelRow* b = rows[dj];
    for (std::size_t di = 0; b && di < kNeighbours; ++di) {
      const float part = kSpline[di] * kSpline[dj];
      const int shift = kMargin + (static_cast<int>(di) - kNeighbours / 2) * step;
      LIPPMANN_FOR_COLUMNS(i, count) {
        const int j = i + shift;
        const float weight = b->surface.there[j] * weight_of(material_difference(a.surface, i + kMargin, b->surface, j) +
                                                             plane_difference(planes, a.surface, i, b->surface, j) +
                                                             light_difference(a.light, i + kMargin, b->light, j));
        add(b->light, j, part * weight * influence(a.light.variance[i + kMargin], b->light.variance[j]), sums, i);
      }
    }
  }
}

struct GatherRow {
  SurfaceRow surface{};
  LightRow light{}, guide{};
};

/// Positions of the points of a row in another view. `column` and `row` are those of the pixel to the left of the point.
/// `right` is 1 if the pixel to the right of the point contributes as well.
struct alignas(64) PlaceRow {
  int column[kColumns], row[kColumns], right[kColumns];
};

LIPPMANN_INLINE float perspective(float z, float vergence) { return 1.0f / most(1.0f - z * vergence, 1e-3f); }

/// Finds the positions of a row's points in another view. A point lies between four pixels. `below` selects the upper two of
/// these pixels (0) or the lower two (1).
LIPPMANN_MULTIVERSION
void find_places(const SurfaceRow& a, const SortedViews& views, const SortedViews::Sight& sight, int below, int count,
                 PlaceRow& places) {
  // Pixels with a smaller bilinear weight are skipped.
  constexpr float kLeastShare = 1.0f / 64;
  const Vec2f samples_per_mm = views.samples_per_mm(), size(views.size());
  const float vergence = views.vergence(), first_row = static_cast<float>(views.first_row());
  const float* shifts = views.shifts();
  LIPPMANN_FOR_COLUMNS(i, count) {
    const int j = i + kMargin;
    const float nearer = perspective(a.z[j], vergence);
    const float place_y = sight.first.y - (a.y[j] - sight.k.y * a.z[j]) * nearer * samples_per_mm.y + kLeastShare;
    const float y = least(most(place_y, first_row - 2.0f), first_row + size.y), upper = std::floor(y);
    const int row = static_cast<int>(upper) - views.first_row() + below;
    const float place_x = (a.x[j] - sight.k.x * a.z[j]) * nearer * samples_per_mm.x - sight.first.x - shifts[row] + kLeastShare;
    const float x = least(most(place_x, -2.0f), size.x), left = std::floor(x);
    places.row[i] = y - upper >= 2.0f * kLeastShare || below == 0 ? row : -1;
    places.column[i] = static_cast<int>(left), places.right[i] = x - left >= 2.0f * kLeastShare ? 1 : 0;
  }
}

/// Adds one pixel of another view to each sum. The pixel's weight falls linearly with the distance between its ray and the
/// point, and reaches zero at one sample distance.
LIPPMANN_MULTIVERSION
void add_found(const GatherRow& a, const PlaneRow& planes, const GatherRow& b, const SortedViews& views,
               const SortedViews::Sight& sight, int count, SumRow& sums) {
  const Vec2f samples_per_mm = views.samples_per_mm();
  const float vergence = views.vergence();
  LIPPMANN_FOR_COLUMNS(i, count) {
    const int j = i + kMargin;
    const float nearer = perspective(a.surface.z[j], vergence), back = a.surface.z[j] - b.surface.z[j];
    const float slope_x = sight.k.x - (a.surface.x[j] - sight.k.x * a.surface.z[j]) * nearer * vergence;
    const float slope_y = sight.k.y - (a.surface.y[j] - sight.k.y * a.surface.z[j]) * nearer * vergence;
    const float off_x = (b.surface.x[j] + slope_x * back - a.surface.x[j]) * nearer * samples_per_mm.x;
    const float off_y = (b.surface.y[j] + slope_y * back - a.surface.y[j]) * nearer * samples_per_mm.y;
    const float part = most(1.0f - std::abs(off_x), 0.0f) * most(1.0f - std::abs(off_y), 0.0f);
    const float weight =
        weight_of(material_difference(a.surface, j, b.surface, j) + plane_difference(planes, a.surface, i, b.surface, j) +
                  light_difference(a.guide, j, b.guide, j));
    add(b.light, j, b.surface.there[j] * part * weight, sums, i);
  }
}

LIPPMANN_MULTIVERSION
void start_means(const GatherRow& a, float distance_mm, float vergence, int count, PlaneRow& planes, SumRow& sums) {
  make_planes(a.surface, distance_mm, vergence, count, planes);
  clear(sums, count);
  LIPPMANN_FOR_COLUMNS(i, count) add(a.light, i + kMargin, 1.0f, sums, i);
}

/// Sums over the 7 x 7 pixels around each pixel of a row: the squared change of light by the filter, and the variance of the
/// noise.
struct alignas(64) ChangeRow {
  float change[kRow], variance[kRow];
};

struct BlurRow {
  struct {
    float there[kRow];
  } surface{};
  float change[kRow]{}, variance[kRow]{};
};

LIPPMANN_MULTIVERSION
void add_changes(const std::array<const BlurRow*, 7>& rows, int count, ChangeRow& sums) {
  LIPPMANN_FOR_COLUMNS(i, count) sums.change[i] = sums.variance[i] = 0.0f;
  for (const BlurRow* b : rows)
    for (int di = -kBlurReach; b && di <= kBlurReach; ++di) LIPPMANN_FOR_COLUMNS(i, count) {
        const int j = i + kMargin + di;
        sums.change[i] += b->surface.there[j] * b->change[j], sums.variance[i] += b->surface.there[j] * b->variance[j];
      }
}

}  // namespace

void find_outliers(const SortedViews& views, const Texels& texels, const ThreadPool& pool, std::vector<Estimate>& estimates) {
  for_each_piece(views, 1, pool, [&](const Piece& piece) {
    RowWindow<7, TexelRow> window(views, piece);
    const auto load = [&](std::size_t p, int i, TexelRow& row) {
      set_surface(texels, p, i, row.surface);
      set_light(texels.light + 3 * p, 0.0f, i, row.light);
    };
    for_each_row(views, piece, texels.met, [&](int y) {
      BrightRow found;
      find_brightest(window.around(y, kOutlierReach, texels.met, load), whole_lanes(piece.columns), found);
      for_each_pixel(views, piece, y, texels.met, [&](std::size_t p, int i) {
        const float* light = texels.light + 3 * p;
        const float squared = squares(light[0], light[1], light[2]);
        const bool alone = found.neighbours[i] >= kLeastNeighbours && squared > square(kBrighter) * found.second[i];
        estimates[p].light.x =
            alone && estimates[p].variance >= square(kOneHalf) * squared ? std::sqrt(found.second[i] / squared) : 1.0f;
      });
    });
  });
}

void make_guides(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& estimates,
                 std::vector<Estimate>& guides) {
  for_each_piece(views, 1, pool, [&](const Piece& piece) {
    RowWindow<kNeighbours, TexelRow> window(views, piece);
    const auto load = [&](std::size_t p, int i, TexelRow& row) {
      set_surface(texels, p, i, row.surface);
      set_light(texels.light + 3 * p, estimates[p].variance, i, row.light);
    };
    for_each_row(views, piece, texels.met, [&](int y) {
      SumRow sums;
      pool_neighbours(window.around(y, kGuideReach, texels.met, load), views.sample_distance_mm(), views.vergence(),
                      whole_lanes(piece.columns), sums);
      for_each_pixel(views, piece, y, texels.met, [&](std::size_t p, int i) {
        const float over = 1.0f / sums.weight[i], variance = sums.variance[i] * over;
        guides[p] = {Vec3f(sums.red[i], sums.green[i], sums.blue[i]) * over, variance * (sums.squares[i] * over * over)};
        texels.place[3 * p + 2] = variance;
      });
    });
  });
}

namespace {

/// Averages the points of one row of a piece with the pixels of other views that show them.
class Gatherer {
 public:
  Gatherer(const SortedViews& views, const Texels& texels, const std::vector<Estimate>& guides)
      : views_(views), texels_(texels), guides_(guides) {}

  void gather(const Piece& piece, int y, std::vector<Estimate>& gathered) {
    columns_ = piece.columns, row_ = y;
    std::fill_n(own_->surface.there + kMargin, kColumns, 0.0f);
    for_each_pixel(views_, piece, y, texels_.met, [&](std::size_t p, int i) { read(p, i + kMargin, *own_); });
    start_means(*own_, views_.sample_distance_mm(), views_.vergence(), whole_lanes(columns_), planes_, sums_);
    const ViewGrid& grid = views_.grid();
    const int column = piece.view % grid.columns, row = piece.view / grid.columns;
    for (int d = -kViewReach; d <= kViewReach; ++d) {
      if (d == 0) continue;
      if (column + d >= 0 && column + d < grid.columns) add_view(piece.view + d);
      if (row + d >= 0 && row + d < grid.rows) add_view(piece.view + d * grid.columns);
    }
    for_each_pixel(views_, piece, y, texels_.met, [&](std::size_t p, int i) { gathered[p] = sums_.mean(i); });
  }

 private:
  void read(std::size_t p, int i, GatherRow& row) const {
    row.surface.there[i] = 1.0f;
    set_surface(texels_, p, i, row.surface);
    set_light(texels_.light + 3 * p, texels_.place[3 * p + 2], i, row.light);
    set_light(guides_[p], i, row.guide);
  }

  void add_view(int view) {
    const int lanes = whole_lanes(columns_);
    for (int below = 0; below < 2; ++below) {
      find_places(own_->surface, views_, views_.sight(view), below, lanes, places_);
      for (int right = 0; right < 2; ++right)
        if (read_found(view, right)) add_found(*own_, planes_, *found_, views_, views_.sight(view), lanes, sums_);
    }
  }

  bool read_found(int view, int right) {
    bool any = false;
    const Vec2i size = views_.size();
    for (int i = 0; i < columns_; ++i) {
      float& there = found_->surface.there[i + kMargin];
      there = 0.0f;
      if (own_->surface.there[i + kMargin] == 0.0f || right > places_.right[i]) continue;
      const int x = places_.column[i] + right, y = places_.row[i];
      if (x < 0 || y < 0 || x >= size.x || y >= size.y || std::abs(y - row_) > kMostRowsAway) continue;
      const std::uint32_t p = views_.row(view, y)[x];
      if (p == SortedViews::kNoPixel || !(texels_.met[p] > 0.0f)) continue;
      read(p, i + kMargin, *found_);
      any = true;
    }
    return any;
  }

  const SortedViews& views_;
  const Texels& texels_;
  const std::vector<Estimate>& guides_;
  int columns_ = 0, row_ = 0;
  std::unique_ptr<GatherRow> own_ = std::make_unique<GatherRow>(), found_ = std::make_unique<GatherRow>();
  PlaceRow places_;
  PlaneRow planes_;
  SumRow sums_;
};

}  // namespace

void gather(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& guides,
            std::vector<Estimate>& gathered) {
  for_each_piece(views, 1, pool, [&](const Piece& piece) {
    Gatherer gatherer(views, texels, guides);
    for_each_row(views, piece, texels.met, [&](int y) { gatherer.gather(piece, y, gathered); });
  });
}

void smooth(const SortedViews& views, const Texels& texels, const ThreadPool& pool, int step,
            const std::vector<Estimate>& light, std::vector<Estimate>& smoothed) {
  for_each_piece(views, step, pool, [&](const Piece& piece) {
    RowWindow<kNeighbours, TexelRow> window(views, piece);
    const auto load = [&](std::size_t p, int i, TexelRow& row) {
      set_surface(texels, p, i, row.surface);
      set_light(light[p], i, row.light);
    };
    for_each_row(views, piece, texels.met, [&](int y) {
      SumRow sums;
      smooth_row(window.around(y, kNeighbours / 2 * step, texels.met, load), step, views.sample_distance_mm(), views.vergence(),
                 whole_lanes(piece.columns), sums);
      for_each_pixel(views, piece, y, texels.met, [&](std::size_t p, int i) { smoothed[p] = sums.mean(i); });
    });
  });
}

void find_blur(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& filtered,
               std::vector<Estimate>& share) {
  for_each_piece(views, 1, pool, [&](const Piece& piece) {
    RowWindow<7, BlurRow> window(views, piece);
    const auto load = [&](std::size_t p, int i, BlurRow& row) {
      const float *own = texels.light + 3 * p, *light = &filtered[p].light.x;
      row.change[i] = squares(light[0] - own[0], light[1] - own[1], light[2] - own[2]);
      row.variance[i] = texels.place[3 * p + 2];
    };
    for_each_row(views, piece, texels.met, [&](int y) {
      ChangeRow sums;
      add_changes(window.around(y, kBlurReach, texels.met, load), whole_lanes(piece.columns), sums);
      for_each_pixel(views, piece, y, texels.met, [&](std::size_t p, int i) {
        const float explained = kExplained * sums.variance[i];
        share[p].variance = sums.change[i] > explained ? explained / sums.change[i] : 1.0f;
      });
    });
  });
}

}  // namespace lippmann
