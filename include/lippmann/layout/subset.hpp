// Selects parts of a light field: the same window of every view, or some of the views.
#pragma once

#include <optional>
#include <string>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// A rectangle in a view, in pixels. `offset` is the distance from the top left corner of the view.
struct Crop {
  Vec2i size{0, 0}, offset{0, 0};
};

/// Every step-th index from `first` to `last`. Both limits are included. last < 0: up to the last index.
struct ViewRange {
  int first = 0, last = -1, step = 1;
};

/// Views to keep. Columns are counted from the left, and rows from the bottom.
struct KeptViews {
  ViewRange columns{}, rows{};
};

/// Parses "WxH+X+Y". Throws a usage Error naming `flag`.
Crop read_crop(const std::string& text, const std::string& flag);

/// Parses "COLUMNS" or "COLUMNSxROWS", where each is N, A-B, A-B:STEP or all: "0-47:2", "2-6x2-6", "allx4". Throws a usage
/// Error naming `flag`.
KeptViews read_kept_views(const std::string& text, const std::string& flag);

/// kept_grid() returns the grid of the kept views. kept_number() returns the new number of a view of `grid`, or none if the
/// view is dropped. These functions throw a usage Error naming `flag` if the selection exceeds the grid.
ViewGrid kept_grid(ViewGrid grid, const KeptViews& kept, const std::string& flag);
std::optional<int> kept_number(int view, ViewGrid grid, const KeptViews& kept, const std::string& flag);

/// crop() reduces every view to the window `window`. keep() drops all views that are not in `kept`. Depth and cameras change
/// with the views. These functions throw a usage Error naming `flag` if the selection exceeds the light field.
void crop(LightField& field, const Crop& window, const std::string& flag);
void keep(LightField& field, const KeptViews& kept, const std::string& flag);

}  // namespace lippmann
