// Parts of a light field: the same window of every view, and some of the views.
#pragma once

#include <optional>
#include <string>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Pixels from the top left corner of a view.
struct Crop {
  Vec2i size{0, 0}, offset{0, 0};
};

/// Every step-th of first ... last; last < 0: to the end.
struct ViewRange {
  int first = 0, last = -1, step = 1;
};

/// Which columns of views, from the left, and which rows, from the lowest.
struct KeptViews {
  ViewRange columns, rows;
};

/// "WxH+X+Y". Throws a usage Error.
Crop read_crop(const std::string& text, const std::string& flag);

/// "COLUMNS" or "COLUMNSxROWS", each N, A-B, A-B:STEP or all: "0-47:2", "2-6x2-6", "allx4". Throws a usage Error.
KeptViews read_kept_views(const std::string& text, const std::string& flag);

/// The grid of the views that are kept of one, and the number there of a view of that one; none: it is left out. Both throw a
/// usage Error naming `flag` for what lies outside.
ViewGrid kept_grid(ViewGrid grid, const KeptViews& kept, const std::string& flag);
std::optional<int> number_among_kept(int view, ViewGrid grid, const KeptViews& kept, const std::string& flag);

/// Depth and cameras stay with their views. Both throw a usage Error naming `flag` for what lies outside.
void crop(LightField& field, const Crop& window, const std::string& flag);
void keep(LightField& field, const KeptViews& kept, const std::string& flag);

}  // namespace lippmann
