#include "lippmann/layout/subset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/text_pattern.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

int number(const std::string& digits) {
  int value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

std::vector<int> members(const ViewRange& range, int count, const char* axis, const std::string& flag) {
  const int last = range.last < 0 ? count - 1 : range.last;
  if (range.first > last || last >= count)
    throw usage_error(flag, fmt::format("{0} {1} to {3} are not all among the {2} {0}", axis, range.first, count, last),
                      fmt::format("0 to {}", count - 1));
  std::vector<int> all;
  for (int i = range.first; i <= last; i += range.step) all.push_back(i);
  return all;
}

/// Returns a light field with the properties of `field`, but with another grid and view size, and with a black stack.
LightField like(const LightField& field, ViewGrid grid, Vec2i view_size) {
  LightField other;
  other.grid = grid, other.view_size = view_size;
  other.aspect = field.aspect, other.tiles = field.tiles, other.bits = field.bits;
  other.cameras = field.cameras, other.positions = field.positions, other.poses = field.poses;
  other.depth_bounds_mm = field.depth_bounds_mm, other.points = field.points, other.splits = field.splits;
  other.times = field.times, other.view_depth = field.view_depth, other.hci = field.hci;
  other.lacks_some_depth = field.lacks_some_depth;
  other.stack = blank(field.stack, stack_size(other));
  if (field.depth) other.depth = Image(view_size.x, view_size.y * grid.count(), 1);
  if (field.alpha) other.alpha = Image(view_size.x, view_size.y * grid.count(), 1);
  return other;
}

}  // namespace

Crop read_crop(const std::string& text, const std::string& flag) {
  static const TextPattern pattern("([0-9]{1,6})x([0-9]{1,6})\\+([0-9]{1,6})\\+([0-9]{1,6})");
  const auto found = pattern.match(text);
  if (!found) throw usage_error(flag, "cannot read '" + text + "' as a window", "WxH+X+Y in pixels, such as 512x512+64+0");
  const auto& group = found->groups;
  return {{number(group[1]), number(group[2])}, {number(group[3]), number(group[4])}};
}

KeptViews read_kept_views(const std::string& text, const std::string& flag) {
  static const std::string range = "(?:all|([0-9]{1,6})(?:-([0-9]{1,6})(?::([1-9][0-9]{0,5}))?)?)";
  static const TextPattern pattern(range + "(?:x" + range + ")?");
  const auto found = pattern.match(text);
  if (!found)
    throw usage_error(flag, "cannot read '" + text + "' as views", "COLUMNS or COLUMNSxROWS, each N, A-B, A-B:STEP or all");
  const auto read = [&](std::size_t group) {
    const std::string &first = found->groups[group], &last = found->groups[group + 1], &step = found->groups[group + 2];
    ViewRange kept;
    if (first.empty()) return kept;
    kept.first = kept.last = number(first);
    if (!last.empty()) kept.last = number(last);
    if (!step.empty()) kept.step = number(step);
    return kept;
  };
  return {read(1), read(4)};
}

void crop(LightField& field, const Crop& window, const std::string& flag) {
  const Vec2i end = window.offset + window.size;
  if (window.size.x < 1 || window.size.y < 1 || end.x > field.view_size.x || end.y > field.view_size.y)
    throw usage_error(flag, fmt::format("{}x{}+{}+{} does not lie in views of {}x{} pixels", window.size.x, window.size.y,
                                        window.offset.x, window.offset.y, field.view_size.x, field.view_size.y));
  LightField cropped = like(field, field.grid, window.size);
  std::vector<std::uint32_t> from;
  for (int view = 0; view < field.grid.count(); ++view)
    for (int y = 0; y < window.size.y; ++y)
      for (int x = 0; x < window.size.x; ++x) {
        const auto row = static_cast<std::uint32_t>(view * field.view_size.y + window.offset.y + y);
        from.push_back(row * static_cast<std::uint32_t>(field.view_size.x) + static_cast<std::uint32_t>(window.offset.x + x));
      }
  move_pixels(field.stack, from, cropped.stack, {});
  if (field.depth) move_pixels(*field.depth, from, *cropped.depth, {});
  if (field.alpha) move_pixels(*field.alpha, from, *cropped.alpha, {});
  if (cropped.view_depth) {
    cropped.view_depth->depth = Image(window.size.x, window.size.y, 1);
    from.resize(static_cast<std::size_t>(window.size.x) * static_cast<std::size_t>(window.size.y));  // those of view 0
    move_pixels(field.view_depth->depth, from, cropped.view_depth->depth, {});
  }
  if (cropped.cameras) cropped.cameras->centre_px -= Vec2d(window.offset);
  if (cropped.poses)
    for (PosedCamera& camera : *cropped.poses) camera.size = window.size, camera.principal_px -= Vec2d(window.offset);
  cropped.aspect *=
      static_cast<double>(window.size.x) * field.view_size.y / (static_cast<double>(window.size.y) * field.view_size.x);
  field = std::move(cropped);
}

ViewGrid kept_grid(ViewGrid grid, const KeptViews& kept, const std::string& flag) {
  return {static_cast<int>(members(kept.columns, grid.columns, "columns", flag).size()),
          static_cast<int>(members(kept.rows, grid.rows, "rows", flag).size())};
}

std::optional<int> kept_number(int view, ViewGrid grid, const KeptViews& kept, const std::string& flag) {
  const std::vector<int> columns = members(kept.columns, grid.columns, "columns", flag);
  const std::vector<int> rows = members(kept.rows, grid.rows, "rows", flag);
  const auto column = std::find(columns.begin(), columns.end(), view % grid.columns);
  const auto row = std::find(rows.begin(), rows.end(), view / grid.columns);
  if (column == columns.end() || row == rows.end()) return std::nullopt;
  return static_cast<int>((row - rows.begin()) * std::ssize(columns) + (column - columns.begin()));
}

void keep(LightField& field, const KeptViews& kept, const std::string& flag) {
  const std::vector<int> columns = members(kept.columns, field.grid.columns, "columns", flag);
  const std::vector<int> rows = members(kept.rows, field.grid.rows, "rows", flag);
  LightField fewer = like(field, {static_cast<int>(columns.size()), static_cast<int>(rows.size())}, field.view_size);
  if (fewer.cameras) fewer.cameras->eyes_mm.clear();
  if (fewer.positions) fewer.positions->clear();
  if (fewer.poses) fewer.poses->clear();
  if (fewer.depth_bounds_mm) fewer.depth_bounds_mm->clear();
  if (fewer.splits) fewer.splits->clear();
  if (fewer.times) fewer.times->clear();
  fewer.view_depth.reset();
  const int step = fewer.grid.columns > 1 ? kept.columns.step : kept.rows.step;
  if (fewer.hci) fewer.hci->disparity_px *= step, fewer.hci->frustum_disparity_px *= step;
  int view = 0;
  for (const int row : rows)
    for (const int column : columns) {
      const int source = row * field.grid.columns + column;
      const auto at = static_cast<std::size_t>(source);
      set_view(fewer, view, view_of(field, source));
      if (field.depth) set_depth(fewer, view, depth_of(field, source));
      if (field.alpha) set_alpha(fewer, view, alpha_of(field, source));
      if (field.view_depth && field.view_depth->view == source) fewer.view_depth = {view, field.view_depth->depth};
      if (field.positions) fewer.positions->push_back((*field.positions)[at]);
      if (field.poses) fewer.poses->push_back((*field.poses)[at]);
      if (field.cameras) fewer.cameras->eyes_mm.push_back(field.cameras->eyes_mm[at]);
      if (field.depth_bounds_mm) fewer.depth_bounds_mm->push_back((*field.depth_bounds_mm)[at]);
      if (field.splits) fewer.splits->push_back((*field.splits)[at]);
      if (field.times) fewer.times->push_back((*field.times)[at]);
      ++view;
    }
  field = std::move(fewer);
}

}  // namespace lippmann
