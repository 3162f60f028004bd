#include "apps/lippmann/grid_flag.hpp"

#include <charconv>

#include "lippmann/core/error.hpp"

namespace lippmann::app {

std::optional<ViewGrid> read_grid(const std::string& text, const std::string& flag) {
  if (text.empty()) return std::nullopt;
  ViewGrid grid;
  const char* end = text.data() + text.size();
  const auto columns = std::from_chars(text.data(), end, grid.columns);
  const bool split = columns.ec == std::errc() && columns.ptr != end && *columns.ptr == 'x';
  const auto rows = split ? std::from_chars(columns.ptr + 1, end, grid.rows) : columns;
  const auto in_range = [](int n) { return n >= 1 && n <= 1024; };
  if (!split || rows.ec != std::errc() || rows.ptr != end || !in_range(grid.columns) || !in_range(grid.rows))
    throw usage_error(flag, "'" + text + "' is not a grid", "CxR, such as 8x6, each from 1 to 1024");
  return grid;
}

}  // namespace lippmann::app
