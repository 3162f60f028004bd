// The order in which the pixels of a frame are traced. trace/strip_order.hpp implements it.
#pragma once

namespace lippmann {

/// The order in which the pixels of a frame are traced. Images do not depend on it.
enum class RayOrder {
  kRows,
  kColumns,    ///< column by column below each lens
  kViewTiles,  ///< tiles of one directional view, whose rays all have nearly the same direction
};

/// Returns the value of the command-line flag for the order.
const char* to_string(RayOrder order);

}  // namespace lippmann
