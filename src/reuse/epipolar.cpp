#include "reuse/epipolar.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "reuse/move_points.hpp"

namespace lippmann {
namespace {

constexpr float kContrast = 0.15f;  // of a picture's range; smaller steps are not worth the search
constexpr int kViews = 3;           // to either side
constexpr float kViewCost = 0.03f;  // lenses that a view further away counts as
constexpr float kExact = 1e-3f;     // lenses; a landing so near to the centre is taken as it is
constexpr float kFar = 9.0f;        // lenses; farther than any candidate

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

/// The best candidate on one side of the place.
struct Side {
  Floats cost;   ///< lenses from the place, and what the view's distance adds
  Floats extra;  ///< the latter
  Ints pixel;
};

LIPPMANN_INLINE void take_if(bool better, float cost, float extra, std::int32_t pixel, Side& side, int i) {
  const float old_cost = side.cost.v[i], old_extra = side.extra.v[i];
  const std::int32_t old_pixel = side.pixel.v[i];
  side.cost.v[i] = better ? cost : old_cost;
  side.extra.v[i] = better ? extra : old_extra;
  side.pixel.v[i] = better ? pixel : old_pixel;
}

/// The state of a search for kPointLanes colours; each step fills what the next one needs.
struct Search {
  Ints source, row_begin, column;  ///< pixels: the sample, its row's first
  Ints beside, behind;             ///< its neighbour; that of the two which is behind
  Ids object, object_beside, layer;
  Floats row_place, row_slope;     ///< as in GridLine
  Floats view, slope, place, off;  ///< place: sought, in samples of the view; off: of the landing from the sample's centre
  Floats depth;                    ///< of the layer, mm
  Floats per_view;                 ///< how far its points shift from view to view, samples
  Side left, right;                ///< of the own view, later of all
  Side other_left, other_right;    ///< of other views
};

/// The two pixels that a colour lies between.
struct Samples {
  Ints left, right;
  Floats left_weight;
};

}  // namespace

bool EpipolarSampler::suits(const Optics& optics) {
  const bool lenses =
      std::holds_alternative<LenticularSheet>(optics.model) || std::holds_alternative<MicrolensArray>(optics.model);
  return lenses && whole_pixels_per_lens(optics).x > 0;
}

EpipolarSampler::EpipolarSampler(const Optics& optics, Encoding encoding)
    : grid_(std::get<GridLanding>(make_landing(optics, SplatMode::kView))), linear_film_(encoding == Encoding::kSrgb) {}

namespace {

/// differs[x]: whether float x of a row differs from the one `ahead` floats on by more than about kContrast of a picture's
/// range. Display-referred codes are the values themselves; those of linear film go about with the square root, and |sqrt(a) -
/// sqrt(b)| > c where (a - b)^2 > 2 c^2 (a + b), nearly.
LIPPMANN_MULTIVERSION void compare_floats(const float* row, int count, int ahead, bool linear, std::uint32_t* differs) {
  const float fixed = linear ? 0.0f : kContrast * kContrast, relative = linear ? 2.0f * kContrast * kContrast : 0.0f;
  for (int x = 0; x < count; ++x) {
    const float here = row[x], there = row[x + ahead];
    const float a = here < 1.0f ? here : 1.0f, b = there < 1.0f ? there : 1.0f;
    differs[x] = (a - b) * (a - b) > fixed + relative * (std::abs(a) + std::abs(b)) ? 1u : 0u;
  }
}

/// `differs` has room for the row's floats.
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

/// What the steps need of the grid of samples.
struct Constants {
  float samples_per_mm, shift, vergence;
  float pixels_per_lens, lenses_per_pixel, slope_per_px, width;
  const float *place, *slope;  ///< by column
  const GridLine* lines;       ///< by row

  explicit Constants(const GridLanding& grid)
      : samples_per_mm(grid.c.across.samples_per_mm),
        shift(grid.c.across.shift),
        vergence(grid.c.vergence),
        pixels_per_lens(grid.c.across.step),
        lenses_per_pixel(1.0f / grid.c.across.step),
        slope_per_px(grid.c.across.step > 1.0f ? grid.slope[1] - grid.slope[0] : 0.0f),
        width(static_cast<float>(grid.width)),
        place(grid.place.data()),
        slope(grid.slope.data()),
        lines(grid.lines.data()) {}
};

/// Where a point is seen by a view, in its samples: the centre of sample k is at k + 0.5.
LIPPMANN_INLINE float coordinate(const Constants& c, float x, float z, float slope) {
  return (x + slope * z) / (1.0f - z * c.vergence) * c.samples_per_mm + c.shift;
}

/// 1. How far off its sample's centre a point has landed; the view's own sample on the other side of the place.
LIPPMANN_INLINE void locate(const Constants& constants, const PrimaryPoints& points, const Motion& motion, Search& s) {
  const Constants c = constants;
  Positions p;
  StillLanes still;
  Floats place;
  gather(points.z.data(), s.source.v, s.depth.v);
  gather(points.object.data(), s.source.v, s.object.v);
  gather(c.place, s.column.v, place.v);
  gather(c.slope, s.column.v, s.slope.v);
  for (int i = 0; i < kPointLanes; ++i) {
    const float z = s.depth.v[i];
    p.x[i] = position_on_line(place.v[i], s.slope.v[i], c.vergence, z);
    p.y[i] = -position_on_line(s.row_place.v[i], s.row_slope.v[i], c.vergence, z);
    p.z[i] = z;
  }
  if (motion.uniform())
    move_alike(motion.groups[0], p, still);
  else
    move_each(motion, s.object.v, p, still);
  for (int i = 0; i < kPointLanes; ++i) {
    const float landed = coordinate(c, p.x[i], p.z[i], s.slope.v[i]);
    const float off = landed - std::floor(landed) - 0.5f;
    const float column = static_cast<float>(s.column.v[i]), lens = std::floor((column + 0.5f) * c.lenses_per_pixel);
    const float column_beside = column + (off > 0.0f ? -c.pixels_per_lens : c.pixels_per_lens);
    const bool is_there = (column_beside >= 0.0f) & (column_beside < c.width);
    s.view.v[i] = column - c.pixels_per_lens * lens;
    s.off.v[i] = off;
    s.place.v[i] = lens + 0.5f - off;
    s.beside.v[i] = s.row_begin.v[i] + static_cast<std::int32_t>(is_there ? column_beside : column);
  }
}

/// The layer: the sample, or the one beside it if that is nearer to the viewer.
LIPPMANN_INLINE void choose_layer(const Constants& constants, const PrimaryPoints& points, Search& s) {
  const Constants c = constants;
  Floats z_beside;
  gather(points.z.data(), s.beside.v, z_beside.v);
  gather(points.object.data(), s.beside.v, s.object_beside.v);
  for (int i = 0; i < kPointLanes; ++i) {
    const std::uint32_t object = s.object.v[i], object_beside = s.object_beside.v[i];
    const std::int32_t source = s.source.v[i], beside = s.beside.v[i];
    const float off = s.off.v[i], own = depth_or_behind_all(s.depth.v[i], object);
    const float other = depth_or_behind_all(z_beside.v[i], object_beside);
    const bool other_in_front = other > own;
    const float z = other_in_front ? other : own;
    s.depth.v[i] = z;
    s.per_view.v[i] = c.slope_per_px * z / (1.0f - z * c.vergence) * c.samples_per_mm;
    s.layer.v[i] = other_in_front ? object_beside : object;
    s.behind.v[i] = other_in_front ? source : beside;
    const float missing = (beside == source) | (object_beside == kMissedObject) ? kFar : 0.0f;
    const bool own_left = off <= 0.0f;
    s.left.cost.v[i] = own_left ? -off : 1.0f - off + missing;
    s.right.cost.v[i] = own_left ? 1.0f + off + missing : off;
    s.left.pixel.v[i] = own_left ? source : beside;
    s.right.pixel.v[i] = own_left ? beside : source;
    s.left.extra.v[i] = s.right.extra.v[i] = 0.0f;
  }
}

/// 2. Offers the samples of the view `step` views further right on both sides of the place, as if all lay at the layer's depth.
LIPPMANN_INLINE void offer_view(const Constants& constants, float step, Search& s) {
  const Constants c = constants;
  const float extra = std::abs(step) * kViewCost;
  for (int i = 0; i < kPointLanes; ++i) {
    const float view = s.view.v[i] + step;
    const bool has_layer = s.layer.v[i] < kMissedObject;
    const bool is_view = (view >= 0.0f) & (view < c.pixels_per_lens) & has_layer;
    const float t = s.place.v[i] + step * s.per_view.v[i];
    const float k = std::floor(t), f = t - k - 0.5f;
    const float to_left = f >= 0.0f ? f : 1.0f + f, to_right = 1.0f - to_left;
    const float column = (f >= 0.0f ? k : k - 1.0f) * c.pixels_per_lens + view, next = column + c.pixels_per_lens;
    const bool left_is_there = is_view & (column >= 0.0f) & (column < c.width);
    const bool right_is_there = is_view & (next >= 0.0f) & (next < c.width);
    const std::int32_t left = s.row_begin.v[i] + static_cast<std::int32_t>(left_is_there ? column : 0.0f);
    const std::int32_t right = s.row_begin.v[i] + static_cast<std::int32_t>(right_is_there ? next : 0.0f);
    take_if(left_is_there & (to_left + extra < s.other_left.cost.v[i]), to_left + extra, extra, left, s.other_left, i);
    take_if(right_is_there & (to_right + extra < s.other_right.cost.v[i]), to_right + extra, extra, right, s.other_right, i);
  }
}

/// 3. Looks at what the best sample of other views on one side (-1 left, 1 right) shows; takes it where it tells more than the
/// own view's samples.
LIPPMANN_INLINE void look_at(const Constants& constants, const PrimaryPoints& points, const Side& best, float side, Search& s) {
  const Constants c = constants;
  Floats z, place, slope;
  Ids id;
  Ints column;
  for (int i = 0; i < kPointLanes; ++i) column.v[i] = best.pixel.v[i] - s.row_begin.v[i];
  gather(c.place, column.v, place.v);
  gather(c.slope, column.v, slope.v);
  gather(points.z.data(), best.pixel.v, z.v);
  gather(points.object.data(), best.pixel.v, id.v);
  for (int i = 0; i < kPointLanes; ++i) {
    const std::int32_t pixel_there = best.pixel.v[i], pixel_behind = s.behind.v[i];
    const float cost_there = best.cost.v[i], extra = best.extra.v[i];
    const float x = position_on_line(place.v[i], slope.v[i], c.vergence, z.v[i]);
    const float r = coordinate(c, x, z.v[i], s.slope.v[i]) - s.place.v[i];
    // Selections of numbers, one condition each: that is what the compiler turns into vector instructions.
    float as_end = s.object.v[i] != s.object_beside.v[i] ? cost_there : kFar;
    as_end = depth_or_behind_all(z.v[i], id.v[i]) <= s.depth.v[i] ? as_end : kFar;
    as_end = id.v[i] != kMissedObject ? as_end : kFar;
    const float as_layer = std::abs(r) <= 1.0f ? std::abs(r) + extra : kFar;
    const bool on_layer = id.v[i] == s.layer.v[i];
    const float seen = on_layer ? as_layer : as_end, cost = cost_there < kFar ? seen : kFar, where = on_layer ? r : side;
    const float left_cost = where <= 0.0f ? cost : kFar, right_cost = where <= 0.0f ? kFar : cost;
    const std::int32_t pixel = on_layer ? pixel_there : pixel_behind;
    take_if(left_cost < s.left.cost.v[i], left_cost, extra, pixel, s.left, i);
    take_if(right_cost < s.right.cost.v[i], right_cost, extra, pixel, s.right, i);
  }
}

/// 4. By distance alone, without what views have cost. Background has no place of its own, and needs none.
LIPPMANN_INLINE void weigh(const Search& s, Samples& out) {
  for (int i = 0; i < kPointLanes; ++i) {
    const bool exact = (std::abs(s.off.v[i]) < kExact) | (s.object.v[i] >= kMissedObject);
    const float left_cost = s.left.cost.v[i], right_cost = s.right.cost.v[i];
    const std::int32_t source = s.source.v[i], left = s.left.pixel.v[i], right = s.right.pixel.v[i];
    const std::int32_t some_left = left_cost < kFar ? left : right, some_right = right_cost < kFar ? right : left;
    out.left.v[i] = exact ? source : some_left;
    out.right.v[i] = exact ? source : some_right;
    const float to_left = left_cost - s.left.extra.v[i], to_right = right_cost - s.right.extra.v[i];
    out.left_weight.v[i] = exact ? 1.0f : to_right / (to_left + to_right);
  }
}

LIPPMANN_MULTIVERSION void find_samples(const Constants& c, const PrimaryPoints& points, const Motion& motion,
                                        const std::uint32_t* sources, Samples& out) {
  Search s;
  for (int i = 0; i < kPointLanes; ++i) {
    s.source.v[i] = static_cast<std::int32_t>(sources[i]);
    const std::uint32_t width = static_cast<std::uint32_t>(c.width), row = sources[i] / width;
    s.row_begin.v[i] = static_cast<std::int32_t>(row * width);
    s.column.v[i] = static_cast<std::int32_t>(sources[i] - row * width);
    s.row_place.v[i] = c.lines[row].place, s.row_slope.v[i] = c.lines[row].slope;
    s.other_left.cost.v[i] = s.other_right.cost.v[i] = kFar;
    s.other_left.extra.v[i] = s.other_right.extra.v[i] = 0.0f;
    s.other_left.pixel.v[i] = s.other_right.pixel.v[i] = s.source.v[i];
  }
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
