#include "denoise/sorted_views.hpp"

#include <map>

#include "denoise/lens_cells.hpp"
#include "layout/film_layout.hpp"
#include "optics/model.hpp"
#include "optics/ray_generator.hpp"

namespace lippmann {
namespace {

/// The line of a pixel's ray.
struct PixelLine {
  std::uint32_t pixel;
  int row;  ///< of the film
  Vec2d place, k;
};

/// fn(line) for every pixel of the film, row by row.
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

/// The pixel of its cell, counted from a corner. Pixels that lie alike below many lenses are not where rounding decides.
Vec2i in_cell_px(const LensCells::Cell& cell) { return Vec2i(glm::floor(cell.in_cell + 0.0137)); }

/// Lenses and pixels below them, first and last.
struct LensBounds {
  std::map<int, Vec2i> columns_of_rows;
  Vec2i first_px{std::numeric_limits<int>::max()}, last_px{std::numeric_limits<int>::min()};
  int most_in_row = 0;  ///< pixels of one row of the film below one lens

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
  int rows() const { return columns_of_rows.rbegin()->first - columns_of_rows.begin()->first + 1; }

 private:
  int row_ = -1;
  std::map<int, int> in_row_;
};

}  // namespace

SortedViews::SortedViews(const Optics& optics) {
  const OpticsFacts facts = optics_facts(optics);
  vergence_ = std::isfinite(facts.viewing_distance_mm) ? 1.0f / facts.viewing_distance_mm : 0.0f;
  samples_per_mm_ = {1.0 / facts.samples.across_mm, 1.0 / facts.samples.down_mm};
  if (const std::optional<LensCells> cells = LensCells::of(optics)) {
    samples_per_mm_.x = static_cast<float>(1.0 / facts.lens_step_mm);
    sort_by_lenses(optics, *cells);
  } else {
    sort_by_tiles(optics);
  }
}

void SortedViews::sort_by_tiles(const Optics& optics) {
  const Vec2i film = film_size(optics);
  const ViewLayout layout = view_tiles(optics) ? film_layout(optics, "denoise") : ViewLayout{LayoutKind::kStack, {1, 1}, {}};
  grid_ = layout.grid;
  size_ = view_size(layout, film, "denoise");
  pixels_ = pixels_of_views(layout, size_, film);
  shifts_.assign(static_cast<std::size_t>(size_.y + 2 * kBeyond), 0.0f);
  const Vec2i middle = size_ / 2;
  const RayGenerator rays(optics);
  for (int view = 0; view < views(); ++view) {
    const std::uint32_t pixel = row(view, middle.y)[middle.x], width = static_cast<std::uint32_t>(film.x);
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

void SortedViews::sort_by_lenses(const Optics& optics, const LensCells& cells) {
  LensBounds bounds;
  for_each_line(optics, vergence_,
                [&](const PixelLine& line) { bounds.add(cells.cell_of(line.place, line.k, line.row), line.row); });
  grid_ = {std::max(bounds.last_px.x - bounds.first_px.x + 1, bounds.most_in_row), bounds.last_px.y - bounds.first_px.y + 1};
  size_ = {bounds.most_columns(), bounds.rows()};
  pixels_.assign(slot(views(), 0), kNoPixel);
  shifts_.assign(static_cast<std::size_t>(size_.y + 2 * kBeyond), 0.0f);
  struct Sums {
    Vec2d k{0.0}, first{0.0};
    int pixels = 0;
  };
  std::vector<Sums> sums(static_cast<std::size_t>(views()));
  for_each_line(optics, vergence_, [&](const PixelLine& line) {
    const LensCells::Cell cell = cells.cell_of(line.place, line.k, line.row);
    const int y = cell.lens.y - bounds.columns_of_rows.begin()->first, x = cell.lens.x - bounds.columns_of_rows[cell.lens.y].x;
    const Vec2i px = in_cell_px(cell) - bounds.first_px;
    const int view = free_view(px, x, y);
    if (view < 0) return;  // stays as traced; no optics are known of which this happens
    pixels_[slot(view, y) + static_cast<std::size_t>(x)] = line.pixel;
    const Vec2d at = line.place * Vec2d(samples_per_mm_);
    shifts_[static_cast<std::size_t>(y + kBeyond)] = static_cast<float>(at.x - cell.in_lens - x);
    Sums& sum = sums[static_cast<std::size_t>(view)];
    sum.k += line.k, sum.first += Vec2d(cell.in_lens, y + at.y), ++sum.pixels;
  });
  for (const Sums& sum : sums)
    sights_.push_back({Vec2f(sum.k / std::max(1.0, 1.0 * sum.pixels)), Vec2f(sum.first / std::max(1.0, 1.0 * sum.pixels))});
}

}  // namespace lippmann
