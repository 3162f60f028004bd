#include "bench/view_resolver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bench/timing.hpp"
#include "device/lanes.hpp"

namespace lippmann::bench {
namespace {

/// More samples in one pixel are dropped: twice what lands there on average from 15 views of 4 samples.
constexpr int kSlots = 128;
/// Places across and down a pixel, for kVoronoi.
constexpr int kVoronoiSide = 4;

/// What has landed in the pixels of one row. An array per quantity, slot by slot of kLanes neighbouring pixels, so that a lane
/// is a pixel.
struct LandedBlock {
  using Slots = std::array<Lanes, kSlots>;
  Slots dx, dy;  ///< place within the pixel, 0 ... 1
  Slots shift;
  Slots red, green, blue;
  alignas(64) std::int32_t surface[kSlots][kLanes];
  alignas(64) std::int32_t count[kLanes];
};

/// A row of blocks.
struct LandedRow {
  std::vector<LandedBlock> blocks;

  explicit LandedRow(int width) : blocks(packets_of(static_cast<std::size_t>(width))) {}
  void clear() {
    for (LandedBlock& block : blocks) std::fill_n(block.count, kLanes, 0);
  }
};

struct Place {
  float x = 0.0f;
  int column = 0, row = 0;
  float dx = 0.0f, dy = 0.0f;
};

/// Lands the samples of a row of other views in one view.
class Landing {
 public:
  Landing(std::span<const ViewSamples> views, int target, float same_surface)
      : into_(views[static_cast<std::size_t>(target)]), same_surface_(same_surface) {
    std::vector<const ViewSamples*> own;
    for (const ViewSamples& view : views)
      if (view.eye_mm == into_.eye_mm) own.push_back(&view);
    cells_ = static_cast<int>(std::sqrt(static_cast<double>(own.size())));
    set_farthest(own);
  }

  void land(const ViewSamples& from, int row, LandedRow& landed) const {
    const bool is_same_view = from.eye_mm == into_.eye_mm;
    const auto step_mm = static_cast<float>(into_.eye_mm - from.eye_mm);
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(from.width);
    for (std::size_t i = first; i < first + static_cast<std::size_t>(from.width); ++i) {
      const float x = from.x[i] + from.shift[i] * step_mm;
      if (!(x >= 0.0f && x < static_cast<float>(into_.width))) continue;
      const int column = static_cast<int>(x);
      const Place place{x, column, row, x - static_cast<float>(column), from.y[i] - static_cast<float>(row)};
      if (!is_same_view && is_hidden(place, from.shift[i])) continue;
      std::size_t colour = i;
      const ViewSamples* colours = &from;
      if (!is_same_view && from.own[i]) {
        const int seen = own_sample_of(place, from.surface[i]);
        if (seen < 0) continue;
        colour = static_cast<std::size_t>(seen), colours = &into_;
      }
      append(place, from.shift[i], from.surface[i], &colours->rgb[3 * colour], landed);
    }
  }

 private:
  int at(int column, int row) const {
    return std::clamp(row, 0, into_.height - 1) * into_.width + std::clamp(column, 0, into_.width - 1);
  }
  /// A cell of the view.
  std::size_t cell(int column, int row) const {
    column = std::clamp(column, 0, cells_ * into_.width - 1), row = std::clamp(row, 0, cells_ * into_.height - 1);
    return static_cast<std::size_t>(row * cells_ * into_.width + column);
  }
  float farthest_at(int column, int row) const { return farthest_[cell(column, row)]; }

  /// A cell in which no sample of the view's own lies has that of the pixel which is farthest.
  void set_farthest(const std::vector<const ViewSamples*>& own) {
    constexpr float kNone = -std::numeric_limits<float>::infinity();
    farthest_.assign(into_.shift.size() * static_cast<std::size_t>(cells_ * cells_), kNone);
    std::vector<float> of_pixel(into_.shift.size(), kNone);
    const auto cells = static_cast<float>(cells_);
    for (const ViewSamples* view : own)
      for (std::size_t i = 0; i < of_pixel.size(); ++i) {
        float& of_cell = farthest_[cell(static_cast<int>(cells * view->x[i]), static_cast<int>(cells * view->y[i]))];
        of_cell = std::max(of_cell, view->shift[i]);
        of_pixel[i] = std::max(of_pixel[i], view->shift[i]);
      }
    for (int row = 0; row < cells_ * into_.height; ++row)
      for (int column = 0; column < cells_ * into_.width; ++column)
        if (float& of_cell = farthest_[cell(column, row)]; of_cell == kNone)
          of_cell = of_pixel[static_cast<std::size_t>(at(column / cells_, row / cells_))];
  }

  /// Whether all of the view's own samples in the four cells around a place are of nearer surfaces.
  bool is_hidden(const Place& place, float shift) const {
    const float x = static_cast<float>(cells_) * place.x,
                y = static_cast<float>(cells_) * (static_cast<float>(place.row) + place.dy);
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const int across = x - static_cast<float>(column) < 0.5f ? -1 : 1, down = y - static_cast<float>(row) < 0.5f ? -1 : 1;
    const float farthest = std::max(std::max(farthest_at(column, row), farthest_at(column + across, row)),
                                    std::max(farthest_at(column, row + down), farthest_at(column + across, row + down)));
    return shift > farthest + same_surface_;
  }

  /// The view's own sample of a surface that is nearest to a place, within a pixel of it; -1: none.
  int own_sample_of(const Place& place, std::int32_t surface) const {
    int nearest = -1;
    float least = 4.0f;
    for (int down = -1; down <= 1; ++down)
      for (int across = -1; across <= 1; ++across) {
        const int i = at(place.column + across, place.row + down);
        const auto s = static_cast<std::size_t>(i);
        if (into_.surface[s] != surface) continue;
        const float x = into_.x[s] - place.x, y = into_.y[s] - static_cast<float>(place.row) - place.dy;
        if (x * x + y * y < least) least = x * x + y * y, nearest = i;
      }
    return nearest;
  }

  static void append(const Place& place, float shift, std::int32_t surface, const float* rgb, LandedRow& landed) {
    LandedBlock& block = landed.blocks[static_cast<std::size_t>(place.column / kLanes)];
    const int lane = place.column % kLanes;
    const int slot = block.count[lane];
    if (slot == kSlots) return;
    const auto s = static_cast<std::size_t>(slot);
    block.dx[s][lane] = place.dx, block.dy[s][lane] = place.dy, block.shift[s][lane] = shift;
    block.red[s][lane] = rgb[0], block.green[s][lane] = rgb[1], block.blue[s][lane] = rgb[2];
    block.surface[slot][lane] = surface;
    ++block.count[lane];
  }

  const ViewSamples& into_;
  float same_surface_;
  int cells_ = 1;                ///< across and down a pixel: as many as it has samples of the view's own
  std::vector<float> farthest_;  ///< of the view's own samples, by cell
};

struct Colours {
  Lanes red, green, blue;
};

int most_samples(const LandedBlock& block) { return *std::max_element(block.count, block.count + kLanes); }

LIPPMANN_MULTIVERSION void resolve_by_count(const LandedBlock& block, Colours& colours) {
  alignas(64) float red[kLanes]{}, green[kLanes]{}, blue[kLanes]{};
  const int most = most_samples(block);
  for (int slot = 0; slot < most; ++slot) {
    const auto s = static_cast<std::size_t>(slot);
    LIPPMANN_FOR_LANES(i) {
      const float weight = slot < block.count[i] ? 1.0f : 0.0f;
      red[i] += weight * block.red[s].lane[i], green[i] += weight * block.green[s].lane[i];
      blue[i] += weight * block.blue[s].lane[i];
    }
  }
  LIPPMANN_FOR_LANES(i) {
    const float each = 1.0f / static_cast<float>(std::max(block.count[i], 1));
    colours.red[i] = each * red[i], colours.green[i] = each * green[i], colours.blue[i] = each * blue[i];
  }
}

LIPPMANN_MULTIVERSION void resolve_by_nearest(const LandedBlock& block, Colours& colours) {
  alignas(64) float red[kLanes]{}, green[kLanes]{}, blue[kLanes]{};
  const int most = most_samples(block);
  for (int part = 0; part < kVoronoiSide * kVoronoiSide; ++part) {
    const float x = (static_cast<float>(part % kVoronoiSide) + 0.5f) / kVoronoiSide;
    const float y = (static_cast<float>(part / kVoronoiSide) + 0.5f) / kVoronoiSide;
    alignas(64) float least[kLanes], r[kLanes]{}, g[kLanes]{}, b[kLanes]{};
    LIPPMANN_FOR_LANES(i) least[i] = 4.0f;
    for (int slot = 0; slot < most; ++slot) {
      const auto s = static_cast<std::size_t>(slot);
      LIPPMANN_FOR_LANES(i) {
        const float dx = block.dx[s].lane[i] - x, dy = block.dy[s].lane[i] - y, distance = dx * dx + dy * dy;
        const bool nearer = (slot < block.count[i]) & (distance < least[i]);
        least[i] = nearer ? distance : least[i];
        r[i] = nearer ? block.red[s].lane[i] : r[i], g[i] = nearer ? block.green[s].lane[i] : g[i];
        b[i] = nearer ? block.blue[s].lane[i] : b[i];
      }
    }
    LIPPMANN_FOR_LANES(i) { red[i] += r[i], green[i] += g[i], blue[i] += b[i]; }
  }
  constexpr float kEach = 1.0f / (kVoronoiSide * kVoronoiSide);
  LIPPMANN_FOR_LANES(i) {
    colours.red[i] = kEach * red[i], colours.green[i] = kEach * green[i], colours.blue[i] = kEach * blue[i];
  }
}

LIPPMANN_INLINE float square_above(float v) { return v > 0.0f ? v * v : 0.0f; }

/// The part of the unit square where n.x x + n.y y < offset; n of length 1.
LIPPMANN_INLINE float area_below(float nx, float ny, float offset) {
  const float a = std::max(std::abs(nx), 1e-3f), b = std::max(std::abs(ny), 1e-3f);
  const float t = offset - std::min(nx, 0.0f) - std::min(ny, 0.0f);
  const float area = square_above(t) - square_above(t - a) - square_above(t - b) + square_above(t - a - b);
  return std::clamp(area / (2.0f * a * b), 0.0f, 1.0f);
}

/// What is near is the surface of the nearest sample; all others are far.
LIPPMANN_MULTIVERSION void resolve_by_lines(const LandedBlock& block, Colours& colours) {
  alignas(64) std::int32_t near[kLanes];
  alignas(64) float nearest[kLanes];
  const int most = most_samples(block);
  LIPPMANN_FOR_LANES(i) { near[i] = block.surface[0][i], nearest[i] = block.shift[0].lane[i]; }
  for (int slot = 1; slot < most; ++slot) {
    const auto s = static_cast<std::size_t>(slot);
    LIPPMANN_FOR_LANES(i) {
      const bool nearer = (slot < block.count[i]) & (block.shift[s].lane[i] < nearest[i]);
      nearest[i] = nearer ? block.shift[s].lane[i] : nearest[i], near[i] = nearer ? block.surface[slot][i] : near[i];
    }
  }
  alignas(64) float n[2][kLanes]{}, x[2][kLanes]{}, y[2][kLanes]{}, r[2][kLanes]{}, g[2][kLanes]{}, b[2][kLanes]{};
  for (int slot = 0; slot < most; ++slot) {
    const auto s = static_cast<std::size_t>(slot);
    LIPPMANN_FOR_LANES(i) {
      const float is = slot < block.count[i] ? 1.0f : 0.0f, in_near = block.surface[slot][i] == near[i] ? is : 0.0f;
      const float in_far = is - in_near;
      n[0][i] += in_near, x[0][i] += in_near * block.dx[s].lane[i], y[0][i] += in_near * block.dy[s].lane[i];
      r[0][i] += in_near * block.red[s].lane[i], g[0][i] += in_near * block.green[s].lane[i];
      b[0][i] += in_near * block.blue[s].lane[i];
      n[1][i] += in_far, x[1][i] += in_far * block.dx[s].lane[i], y[1][i] += in_far * block.dy[s].lane[i];
      r[1][i] += in_far * block.red[s].lane[i], g[1][i] += in_far * block.green[s].lane[i];
      b[1][i] += in_far * block.blue[s].lane[i];
    }
  }
  alignas(64) float nx[kLanes], ny[kLanes], last[kLanes], first[kLanes];
  LIPPMANN_FOR_LANES(i) {
    const float near_count = std::max(n[0][i], 1.0f), far_count = std::max(n[1][i], 1.0f);
    const float dx = x[1][i] / far_count - x[0][i] / near_count, dy = y[1][i] / far_count - y[0][i] / near_count;
    const float inverse = 1.0f / std::max(std::sqrt(dx * dx + dy * dy), 1e-6f);
    nx[i] = dx * inverse, ny[i] = dy * inverse, last[i] = -4.0f, first[i] = 4.0f;
  }
  for (int slot = 0; slot < most; ++slot) {
    const auto s = static_cast<std::size_t>(slot);
    LIPPMANN_FOR_LANES(i) {
      const float along = nx[i] * block.dx[s].lane[i] + ny[i] * block.dy[s].lane[i];
      const bool is = slot < block.count[i], in_near = block.surface[slot][i] == near[i];
      last[i] = is & in_near ? std::max(last[i], along) : last[i];
      first[i] = is & !in_near ? std::min(first[i], along) : first[i];
    }
  }
  LIPPMANN_FOR_LANES(i) {
    const float all = std::max(n[0][i] + n[1][i], 1.0f), counted = n[0][i] / all;
    const float by_line = area_below(nx[i], ny[i], 0.5f * (last[i] + first[i]));
    const float share = (n[1][i] > 0.0f) & (last[i] < first[i]) ? by_line : counted;
    const float near_each = share / std::max(n[0][i], 1.0f), far_each = (1.0f - share) / std::max(n[1][i], 1.0f);
    colours.red[i] = near_each * r[0][i] + far_each * r[1][i];
    colours.green[i] = near_each * g[0][i] + far_each * g[1][i];
    colours.blue[i] = near_each * b[0][i] + far_each * b[1][i];
  }
}

void resolve(const LandedBlock& block, Resolver how, Colours& colours) {
  if (how == Resolver::kVoronoi) return resolve_by_nearest(block, colours);
  if (how == Resolver::kLines) return resolve_by_lines(block, colours);
  resolve_by_count(block, colours);
}

void resolve_row(const LandedRow& landed, Resolver how, int width, float* row) {
  for (std::size_t b = 0; b < landed.blocks.size(); ++b) {
    Colours colours;
    resolve(landed.blocks[b], how, colours);
    const int first = static_cast<int>(b) * kLanes;
    for (int i = 0; i < std::min(kLanes, width - first); ++i) {
      float* pixel = row + 3 * (first + i);
      pixel[0] = colours.red[i], pixel[1] = colours.green[i], pixel[2] = colours.blue[i];
    }
  }
}

}  // namespace

Image resolve_view(std::span<const ViewSamples> views, int target, int reach, float same_surface, Resolver how,
                   ResolveTimes* times) {
  const ViewSamples& into = views[static_cast<std::size_t>(target)];
  const int around = how == Resolver::kOwn ? 0 : reach;
  const int first = std::max(0, target - around), last = std::min(static_cast<int>(views.size()) - 1, target + around);
  Image picture(into.width, into.height, 3);
  const Landing landing(views, target, same_surface);
  LandedRow landed(into.width);  // of one row at a time, which stays in the cache
  for (int row = 0; row < into.height; ++row) {
    const double land_seconds = seconds([&] {
      landed.clear();
      landing.land(into, row, landed);  // its own first, so that no pixel is without one
      for (int view = first; view <= last; ++view)
        if (view != target) landing.land(views[static_cast<std::size_t>(view)], row, landed);
    });
    const double resolve_seconds = seconds([&] { resolve_row(landed, how, into.width, picture.pixel(0, row)); });
    if (times) times->land_seconds += land_seconds, times->resolve_seconds += resolve_seconds;
  }
  return picture;
}

}  // namespace lippmann::bench
