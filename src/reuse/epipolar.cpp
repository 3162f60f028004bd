#include "reuse/epipolar.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "reuse/move_points.hpp"

namespace lippmann {
namespace {

// Colours are interpolated if neighbouring samples differ by more than this fraction of the range of colours.
constexpr float kContrast = 0.15f;
constexpr int kViews = 3;  // number of views searched on each side of the pixel's view
// Penalty per view between the pixel's view and the sample's view, added to the distance in lenses.
constexpr float kViewCost = 0.03f;
// A point closer than this to the sample's centre, in lenses, uses the sample's colour unchanged.
constexpr float kExact = 1e-3f;
// Cost of a missing sample, in lenses. All other costs are lower.
constexpr float kFar = 9.0f;

template <class T>
LIPPMANN_INLINE void gather(const T* from, const std::int32_t* index, T* to) {
  for (int i = 0; i < kPointLanes; ++i) to[i] = from[index[i]];
}

LIPPMANN_INLINE float depth_or_behind_all(float z, std::uint32_t object) { return object >= kMissedObject ? -3e38f : z; }

struct alignas(64) Floats {
  float v[kPointLanes];
};
struct alignas(64) Ints {
  std::int32_t v[kPointLanes];
};
struct alignas(64) Ids {
  std::uint32_t v[kPointLanes];
};

struct Side {
  /// Distance from the searched position in lenses, plus the penalty (kViewCost).
  Floats cost;
  Floats extra;
  Floats column;
};

LIPPMANN_INLINE void take_if(bool better, float cost, float extra, float column, Side& side, int i) {
  const float old_cost = side.cost.v[i], old_extra = side.extra.v[i], old_column = side.column.v[i];
  side.cost.v[i] = better ? cost : old_cost;
  side.extra.v[i] = better ? extra : old_extra;
  side.column.v[i] = better ? column : old_column;
}

struct Candidate {
  Floats cost, column;
};

LIPPMANN_INLINE void offer(float cost, float column, Candidate& best, int i) {
  const float old_cost = best.cost.v[i], old_column = best.column.v[i];
  best.cost.v[i] = cost < old_cost ? cost : old_cost;
  best.column.v[i] = cost < old_cost ? column : old_column;
}

struct Search {
  Ints source, row_begin;
  Floats row, column;
  /// `beside`: column of the next sample of the same view. `behind`: column of the sample farther from the viewer, of the
  /// current sample and the sample at `beside`.
  Floats beside, behind;
  Ids object, object_beside, layer;
  /// view: number of the view. place: searched position in the view, in samples. off: offset of the projected point from its
  /// nearest sample, in samples.
  Floats view, place, off;
  Floats slope;
  Floats depth;     ///< depth of the surface that the pixel shows, mm
  Floats per_view;  ///< shift of a point of this surface from view to view, in samples
  Side left, right;
  Candidate other_left, other_right;
};

struct Samples {
  Ints left, right;
  Floats left_weight;
};

}  // namespace

bool EpipolarSampler::suits(const Optics& optics) { return has_lenses(optics) && whole_pixels_per_lens(optics).x > 0; }

EpipolarSampler::EpipolarSampler(const Optics& optics, Encoding encoding)
    : grid_(std::get<GridLanding>(make_landing(optics, SplatMode::kView))), linear_film_(encoding == Encoding::kSrgb) {}

namespace {

/// Sets differs[x] if floats x and x + ahead differ by more than about kContrast of the image's range. Linear values are
/// compared by square root: |sqrt(a) - sqrt(b)| > c is nearly equivalent to (a - b)^2 > 2 c^2 (a + b).
LIPPMANN_MULTIVERSION void compare_floats(const float* row, int count, int ahead, bool linear, std::uint32_t* differs) {
  const float fixed = linear ? 0.0f : kContrast * kContrast, relative = linear ? 2.0f * kContrast * kContrast : 0.0f;
  for (int x = 0; x < count; ++x) {
    const float here = row[x], there = row[x + ahead];
    const float a = here < 1.0f ? here : 1.0f, b = there < 1.0f ? there : 1.0f;
    differs[x] = (a - b) * (a - b) > fixed + relative * (std::abs(a) + std::abs(b)) ? 1u : 0u;
  }
}

/// Fills one row of PointImage::contrast. `step` is the distance in pixels to the next sample of a view.
LIPPMANN_MULTIVERSION void contrast_of_row(const float* colors, int width, int step, bool linear, std::uint32_t* differs,
                                           std::uint8_t* contrast) {
  const int pairs = std::max(0, width - step);
  compare_floats(colors, 3 * pairs, 3 * step, linear, differs);
  std::memset(contrast, 0, static_cast<std::size_t>(width));
  for (int i = 0; i < pairs; ++i)
    contrast[i] = static_cast<std::uint8_t>(differs[3 * i] | differs[3 * i + 1] | differs[3 * i + 2]);
  for (int i = width - 1; i >= step; --i) contrast[i] = static_cast<std::uint8_t>(contrast[i] | contrast[i - step] << 1);
}

}  // namespace

void EpipolarSampler::find_contrast(PointImage& image, const ThreadPool& pool) const {
  constexpr int kRows = 32;
  const int width = grid_.width, height = static_cast<int>(grid_.lines.size()), step = static_cast<int>(grid_.c.across.step);
  image.contrast.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  pool.for_each(static_cast<std::size_t>((height + kRows - 1) / kRows), [&](std::size_t strip) {
    const int first = static_cast<int>(strip) * kRows;
    std::vector<std::uint32_t> differs(3 * static_cast<std::size_t>(width));
    for (int j = first; j < std::min(height, first + kRows); ++j) {
      const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(width);
      contrast_of_row(image.film.data.data() + 3 * at, width, step, linear_film_, differs.data(), image.contrast.data() + at);
    }
  });
}

namespace {

struct SampleAxis {
  float per_lens, per_pixel;  ///< pixels per lens, and lenses per pixel
  float place, pitch;
  float slope, slope_per_px;  ///< slope of view 0, and difference between neighbouring views
};

struct Sample {
  float lens, view, place, slope;
};

LIPPMANN_INLINE Sample sample_at(const SampleAxis& axis, float pixel) {
  const float lens = std::floor((pixel + 0.5f) * axis.per_pixel), view = pixel - axis.per_lens * lens;
  return {lens, view, axis.place + lens * axis.pitch, axis.slope + view * axis.slope_per_px};
}

template <class Place, class Slope>
SampleAxis sample_axis(const GridScale& scale, int pixels, const Place& place, const Slope& slope) {
  const int step = static_cast<int>(scale.step);
  return {scale.step, 1.0f / scale.step,
          place(0),   pixels > step ? place(step) - place(0) : 0.0f,
          slope(0),   step > 1 ? (slope(step - 1) - slope(0)) / static_cast<float>(step - 1) : 0.0f};
}

struct Constants {
  float samples_per_mm, shift, vergence, width;
  SampleAxis columns, rows;

  explicit Constants(const GridLanding& grid)
      : samples_per_mm(grid.c.across.samples_per_mm),
        shift(grid.c.across.shift),
        vergence(grid.c.vergence),
        width(static_cast<float>(grid.width)),
        columns(sample_axis(
            grid.c.across, grid.width, [&](int i) { return grid.place[static_cast<std::size_t>(i)]; },
            [&](int i) { return grid.slope[static_cast<std::size_t>(i)]; })),
        rows(sample_axis(
            grid.c.down, static_cast<int>(grid.lines.size()),
            [&](int j) { return grid.lines[static_cast<std::size_t>(j)].place; },
            [&](int j) { return grid.lines[static_cast<std::size_t>(j)].slope; })) {}
};

/// Returns where a view whose rays have the slope `slope` shows the point (x, z), in samples. The centre of sample k is at k +
/// 0.5.
LIPPMANN_INLINE float coordinate(const Constants& c, float x, float z, float slope) {
  return (x + slope * z) / (1.0f - z * c.vergence) * c.samples_per_mm + c.shift;
}

LIPPMANN_INLINE void start(const Constants& c, const std::uint32_t* sources, Search& s) {
  const std::int32_t width = static_cast<std::int32_t>(c.width);
  const double rows_per_pixel = 1.0 / static_cast<double>(c.width);
  for (int i = 0; i < kPointLanes; ++i) {
    const std::int32_t source = static_cast<std::int32_t>(sources[i]);
    const std::int32_t row = static_cast<std::int32_t>((static_cast<double>(source) + 0.5) * rows_per_pixel);
    s.source.v[i] = source;
    s.row_begin.v[i] = row * width;
    s.row.v[i] = static_cast<float>(row), s.column.v[i] = static_cast<float>(source - row * width);
    s.other_left.cost.v[i] = s.other_right.cost.v[i] = kFar;
    s.other_left.column.v[i] = s.other_right.column.v[i] = s.column.v[i];
  }
}

LIPPMANN_INLINE void look_up(const PrimaryPoints& points, const Ints& row_begin, const Floats& column, Floats& z, Ids& object) {
  Ints pixel;
  for (int i = 0; i < kPointLanes; ++i) pixel.v[i] = row_begin.v[i] + static_cast<std::int32_t>(column.v[i]);
  gather(points.z.data(), pixel.v, z.v);
  gather(points.object.data(), pixel.v, object.v);
}

LIPPMANN_INLINE void locate(const Constants& constants, const PrimaryPoints& points, const Motion& motion, Search& s) {
  const Constants c = constants;
  Positions p;
  StillLanes still;
  Floats lens;
  look_up(points, s.row_begin, s.column, s.depth, s.object);
  for (int i = 0; i < kPointLanes; ++i) {
    const float z = s.depth.v[i];
    const Sample across = sample_at(c.columns, s.column.v[i]), down = sample_at(c.rows, s.row.v[i]);
    p.x[i] = position_on_line(across.place, across.slope, c.vergence, z);
    p.y[i] = -position_on_line(down.place, down.slope, c.vergence, z);
    p.z[i] = z;
    lens.v[i] = across.lens, s.view.v[i] = across.view, s.slope.v[i] = across.slope;
  }
  if (motion.uniform())
    move_alike(motion.groups[0], p, still);
  else
    move_each(motion, s.object.v, p, still);
  for (int i = 0; i < kPointLanes; ++i) {
    const float landed = coordinate(c, p.x[i], p.z[i], s.slope.v[i]);
    const float off = landed - std::floor(landed) - 0.5f;
    const float column = s.column.v[i], beside = column + (off > 0.0f ? -c.columns.per_lens : c.columns.per_lens);
    const bool is_there = (beside >= 0.0f) & (beside < c.width);
    s.off.v[i] = off;
    s.place.v[i] = lens.v[i] + 0.5f - off;
    s.beside.v[i] = is_there ? beside : column;
  }
}

LIPPMANN_INLINE void choose_layer(const Constants& constants, const PrimaryPoints& points, Search& s) {
  const Constants c = constants;
  Floats z_beside;
  look_up(points, s.row_begin, s.beside, z_beside, s.object_beside);
  for (int i = 0; i < kPointLanes; ++i) {
    const std::uint32_t object = s.object.v[i], object_beside = s.object_beside.v[i];
    const float column = s.column.v[i], beside = s.beside.v[i];
    const float off = s.off.v[i], own = depth_or_behind_all(s.depth.v[i], object);
    const float other = depth_or_behind_all(z_beside.v[i], object_beside);
    const bool other_in_front = other > own;
    const float z = other_in_front ? other : own;
    s.depth.v[i] = z;
    s.per_view.v[i] = c.columns.slope_per_px * z / (1.0f - z * c.vergence) * c.samples_per_mm;
    s.layer.v[i] = other_in_front ? object_beside : object;
    s.behind.v[i] = other_in_front ? column : beside;
    const float missing = ((beside == column) | (object_beside == kMissedObject)) ? kFar : 0.0f;
    const bool own_left = off <= 0.0f;
    s.left.cost.v[i] = own_left ? -off : 1.0f - off + missing;
    s.right.cost.v[i] = own_left ? 1.0f + off + missing : off;
    s.left.column.v[i] = own_left ? column : beside;
    s.right.column.v[i] = own_left ? beside : column;
    s.left.extra.v[i] = s.right.extra.v[i] = 0.0f;
  }
}

LIPPMANN_INLINE void offer_view(const Constants& constants, float step, Search& s) {
  const Constants c = constants;
  const float extra = std::abs(step) * kViewCost;
  for (int i = 0; i < kPointLanes; ++i) {
    const float view = s.view.v[i] + step;
    const bool is_view = (view >= 0.0f) & (view < c.columns.per_lens) & (s.layer.v[i] < kMissedObject);
    const float t = s.place.v[i] + step * s.per_view.v[i] - 0.5f;
    const float lens = std::floor(t), to_left = t - lens;
    const float left = lens * c.columns.per_lens + view, right = left + c.columns.per_lens;
    offer((is_view & (left >= 0.0f) & (left < c.width)) ? to_left + extra : kFar, left, s.other_left, i);
    offer((is_view & (right >= 0.0f) & (right < c.width)) ? 1.0f - to_left + extra : kFar, right, s.other_right, i);
  }
}

LIPPMANN_INLINE void look_at(const Constants& constants, const PrimaryPoints& points, const Candidate& best, float side,
                             Search& s) {
  const Constants c = constants;
  Floats z;
  Ids id;
  look_up(points, s.row_begin, best.column, z, id);
  for (int i = 0; i < kPointLanes; ++i) {
    const float column_there = best.column.v[i], column_behind = s.behind.v[i], cost_there = best.cost.v[i];
    const Sample there = sample_at(c.columns, column_there);
    const float extra = std::abs(there.view - s.view.v[i]) * kViewCost;
    const float x = position_on_line(there.place, there.slope, c.vergence, z.v[i]);
    const float r = coordinate(c, x, z.v[i], s.slope.v[i]) - s.place.v[i];
    // Each selection has a single condition, because the compiler vectorises only such loops.
    float as_end = s.object.v[i] != s.object_beside.v[i] ? cost_there : kFar;
    as_end = depth_or_behind_all(z.v[i], id.v[i]) <= s.depth.v[i] ? as_end : kFar;
    as_end = id.v[i] != kMissedObject ? as_end : kFar;
    const float as_layer = std::abs(r) <= 1.0f ? std::abs(r) + extra : kFar;
    const bool on_layer = id.v[i] == s.layer.v[i];
    const float seen = on_layer ? as_layer : as_end, cost = cost_there < kFar ? seen : kFar, where = on_layer ? r : side;
    const float left_cost = where <= 0.0f ? cost : kFar, right_cost = where <= 0.0f ? kFar : cost;
    const float column = on_layer ? column_there : column_behind;
    take_if(left_cost < s.left.cost.v[i], left_cost, extra, column, s.left, i);
    take_if(right_cost < s.right.cost.v[i], right_cost, extra, column, s.right, i);
  }
}

LIPPMANN_INLINE void weigh(const Search& s, Samples& out) {
  for (int i = 0; i < kPointLanes; ++i) {
    const bool exact = (std::abs(s.off.v[i]) < kExact) | (s.object.v[i] >= kMissedObject);
    const float left_cost = s.left.cost.v[i], right_cost = s.right.cost.v[i];
    const float own = s.column.v[i], left = s.left.column.v[i], right = s.right.column.v[i];
    const float some_left = left_cost < kFar ? left : right, some_right = right_cost < kFar ? right : left;
    out.left.v[i] = s.row_begin.v[i] + static_cast<std::int32_t>(exact ? own : some_left);
    out.right.v[i] = s.row_begin.v[i] + static_cast<std::int32_t>(exact ? own : some_right);
    const float to_left = left_cost - s.left.extra.v[i], to_right = right_cost - s.right.extra.v[i];
    out.left_weight.v[i] = exact ? 1.0f : to_right / (to_left + to_right);
  }
}

LIPPMANN_MULTIVERSION void find_samples(const Constants& c, const PrimaryPoints& points, const Motion& motion,
                                        const std::uint32_t* sources, Samples& out) {
  Search s;
  start(c, sources, s);
  locate(c, points, motion, s);
  choose_layer(c, points, s);
  for (int step = 1; step <= kViews; ++step) {
    offer_view(c, static_cast<float>(-step), s);
    offer_view(c, static_cast<float>(step), s);
  }
  look_at(c, points, s.other_left, -1.0f, s);
  look_at(c, points, s.other_right, 1.0f, s);
  weigh(s, out);
}

}  // namespace

void EpipolarSampler::colors(const PointImage& image, const Motion& motion, std::span<const std::uint32_t> sources,
                             float* colors) const {
  const Constants constants(grid_);
  Samples samples;
  alignas(64) std::uint32_t lanes[kPointLanes];
  const float* film = image.film.data.data();
  for (std::size_t first = 0; first < sources.size(); first += kPointLanes) {
    const std::size_t count = std::min<std::size_t>(kPointLanes, sources.size() - first);
    for (std::size_t i = 0; i < kPointLanes; ++i) lanes[i] = sources[first + std::min(i, count - 1)];
    find_samples(constants, image.points, motion, lanes, samples);
    for (std::size_t i = 0; i < count; ++i, colors += 3) {
      const float *left = film + 3 * static_cast<std::ptrdiff_t>(samples.left.v[i]),
                  *right = film + 3 * static_cast<std::ptrdiff_t>(samples.right.v[i]);
      const float weight = samples.left_weight.v[i];
      for (int c = 0; c < 3; ++c) colors[c] = weight * left[c] + (1.0f - weight) * right[c];
    }
  }
}

}  // namespace lippmann
