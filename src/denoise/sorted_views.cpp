#include "denoise/sorted_views.hpp"

#include <map>

#include "layout/film_layout.hpp"
#include "optics/lens_cells.hpp"
#include "optics/model.hpp"
#include "optics/ray_generator.hpp"

namespace lippmann {
namespace {

/// The ray of a pixel: x(z) = place + s z, with s the slope of the ray. Its view direction is k = place / V + s, with V the
/// viewing distance.
struct PixelLine {
  std::uint32_t pixel;
  int row;
  Vec2d place, k;
};

template <class Fn>
void for_each_line(const Optics& optics, double vergence, const Fn& fn) {
  const RayGenerator generator(optics);
  const Vec2i film = film_size(optics);
  const auto width = static_cast<std::size_t>(film.x);
  std::vector<float> px(width), py(width), numbers(6 * width);
  float* n = numbers.data();
  for (int y = 0; y < film.y; ++y) {
    for (std::size_t x = 0; x < width; ++x) px[x] = static_cast<float>(x) + 0.5f, py[x] = static_cast<float>(y) + 0.5f;
    generator.rays(px.data(), py.data(), film.x, {n, n + width, n + 2 * width, n + 3 * width, n + 4 * width, n + 5 * width});
    for (std::size_t x = 0; x < width; ++x) {
      const Vec3d origin(n[x], n[width + x], n[2 * width + x]), to(n[3 * width + x], n[4 * width + x], n[5 * width + x]);
      const Vec2d slope = Vec2d(to) / to.z, place = Vec2d(origin) - slope * origin.z;
      fn(PixelLine{static_cast<std::uint32_t>(static_cast<std::size_t>(y) * width + x), y, place, place * vergence + slope});
    }
  }
}

/// Returns the pixel of the cell that contains the position. Many positions lie exactly on the boundary of two pixels. The
/// offset of 0.0137 pixels moves them off the boundary, so that rounding errors do not choose the pixel.
Vec2i in_cell_px(const LensCells::Cell& cell) { return Vec2i(glm::floor(cell.in_cell + 0.0137)); }

struct LensBounds {
  std::map<int, Vec2i> columns_of_rows;
  Vec2i first_px{std::numeric_limits<int>::max()}, last_px{std::numeric_limits<int>::min()};
  int most_in_row = 0;

  void add(const LensCells::Cell& cell, int row) {
    Vec2i& columns = columns_of_rows.try_emplace(cell.lens.y, cell.lens.x, cell.lens.x).first->second;
    columns = {std::min(columns.x, cell.lens.x), std::max(columns.y, cell.lens.x)};
    const Vec2i px = in_cell_px(cell);
    first_px = glm::min(first_px, px), last_px = glm::max(last_px, px);
    if (row != row_) in_row_.clear(), row_ = row;
    most_in_row = std::max(most_in_row, ++in_row_[cell.lens.x]);
  }
  int most_columns() const {
    int most = 0;
    for (const auto& [row, columns] : columns_of_rows) most = std::max(most, columns.y - columns.x + 1);
    return most;
  }

 private:
  int row_ = -1;
  std::map<int, int> in_row_;
};

}  // namespace

SortedViews::SortedViews(const Optics& optics, RowRange rows) {
  const OpticsFacts facts = optics_facts(optics);
  vergence_ = std::isfinite(facts.viewing_distance_mm) ? 1.0f / facts.viewing_distance_mm : 0.0f;
  samples_per_mm_ = {1.0 / facts.samples.across_mm, 1.0 / facts.samples.down_mm};
  if (const std::optional<LensCells> cells = lens_cells(optics); cells && std::min(cells->cell_px.x, cells->cell_px.y) >= 1.0) {
    samples_per_mm_.x = static_cast<float>(1.0 / facts.lens_step_mm);
    sort_by_lenses(optics, *cells, rows);
  } else {
    sort_by_tiles(optics, rows);
  }
}

void SortedViews::sort_by_tiles(const Optics& optics, RowRange rows) {
  const Vec2i film = film_size(optics);
  const ViewLayout layout = view_tiles(optics) ? film_layout(optics, "denoise") : ViewLayout{LayoutKind::kStack, {1, 1}, {}};
  grid_ = layout.grid;
  const Vec2i size = view_size(layout, film, "denoise"), middle = size / 2;
  const bool one_row = size.y == film.y;
  first_row_ = one_row ? rows.first : 0;
  size_ = {size.x, one_row ? rows.end - rows.first : size.y};
  shifts_.assign(static_cast<std::size_t>(size_.y + 2 * kBeyond), 0.0f);
  const RayGenerator rays(optics);
  const std::ptrdiff_t width = film.x, first = rows.first * width, end = rows.end * width;
  for (int view = 0; view < views(); ++view) {
    const ViewPlace tile = place_of_view(layout, size, film, view);
    const auto pixel_at = [&](int x, int y) { return tile.first + x * tile.across + y * tile.down; };
    for (int y = 0; y < size_.y; ++y)
      for (int x = 0; x < size_.x; ++x) {
        const std::ptrdiff_t pixel = pixel_at(x, y + first_row_);
        pixels_.push_back(pixel >= first && pixel < end ? static_cast<std::uint32_t>(pixel - first) : kNoPixel);
      }
    const std::ptrdiff_t pixel = pixel_at(middle.x, middle.y);
    const Ray ray = rays.ray({static_cast<float>(pixel % width) + 0.5f, static_cast<float>(pixel / width) + 0.5f});
    const Vec2d slope = Vec2d(ray.direction) / static_cast<double>(ray.direction.z);
    const Vec2d place = Vec2d(ray.origin) - slope * static_cast<double>(ray.origin.z);
    const Vec2d at = place * Vec2d(samples_per_mm_);
    sights_.push_back({Vec2f(place * static_cast<double>(vergence_) + slope), Vec2f(Vec2d(at.x - middle.x, at.y + middle.y))});
  }
}

int SortedViews::free_view(Vec2i at, int x, int y) const {
  for (int away = 0; away < grid_.columns; ++away)
    for (const int column : {at.x + away, at.x - away}) {
      const int view = at.y * grid_.columns + column;
      if (column >= 0 && column < grid_.columns && row(view, y)[x] == kNoPixel) return view;
    }
  return -1;
}

void SortedViews::sort_by_lenses(const Optics& optics, const LensCells& cells, RowRange rows) {
  const auto is_in_rows = [rows](const PixelLine& line) { return line.row >= rows.first && line.row < rows.end; };
  LensBounds bounds;
  Vec2i lens_rows(std::numeric_limits<int>::max(), std::numeric_limits<int>::min());
  for_each_line(optics, vergence_, [&](const PixelLine& line) {
    const LensCells::Cell cell = cells.cell_of(line.place, line.k, line.row);
    bounds.add(cell, line.row);
    if (is_in_rows(line)) lens_rows = {std::min(lens_rows.x, cell.lens.y), std::max(lens_rows.y, cell.lens.y)};
  });
  const int top = bounds.columns_of_rows.begin()->first;
  first_row_ = lens_rows.x - top;
  grid_ = {std::max(bounds.last_px.x - bounds.first_px.x + 1, bounds.most_in_row), bounds.last_px.y - bounds.first_px.y + 1};
  size_ = {bounds.most_columns(), lens_rows.y - lens_rows.x + 1};
  pixels_.assign(slot(views(), 0), kNoPixel);
  shifts_.assign(static_cast<std::size_t>(size_.y + 2 * kBeyond), 0.0f);
  struct Sums {
    Vec2d k{0.0}, first{0.0};
    double pixels = 0.0;
  };
  std::vector<Sums> sums(static_cast<std::size_t>(views()));
  const auto before = static_cast<std::uint32_t>(rows.first) * static_cast<std::uint32_t>(film_size(optics).x);
  for_each_line(optics, vergence_, [&](const PixelLine& line) {
    const LensCells::Cell cell = cells.cell_of(line.place, line.k, line.row);
    const Vec2i px = in_cell_px(cell) - bounds.first_px;
    const Vec2d at = line.place * Vec2d(samples_per_mm_);
    Sums& sum = sums[static_cast<std::size_t>(px.y * grid_.columns + px.x)];
    sum.k += line.k, sum.first += Vec2d(cell.in_lens, cell.lens.y - top + at.y), sum.pixels += 1.0;
    if (!is_in_rows(line)) return;
    const int y = cell.lens.y - lens_rows.x, x = cell.lens.x - bounds.columns_of_rows[cell.lens.y].x;
    const int view = free_view(px, x, y);
    // A pixel without a free view is not denoised. This does not happen with any known optics.
    if (view < 0) return;
    pixels_[slot(view, y) + static_cast<std::size_t>(x)] = line.pixel - before;
    shifts_[static_cast<std::size_t>(y + kBeyond)] = static_cast<float>(at.x - cell.in_lens - x);
  });
  // A view without pixels in its own direction gets the Sight of the previous view.
  Sight sight;
  for (const Sums& sum : sums) {
    if (sum.pixels > 0.0) sight = {Vec2f(sum.k / sum.pixels), Vec2f(sum.first / sum.pixels)};
    sights_.push_back(sight);
  }
}

}  // namespace lippmann
