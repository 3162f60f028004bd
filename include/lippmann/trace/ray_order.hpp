// The order in which the pixels of a frame are traced. Images do not depend on it.
#pragma once

namespace lippmann {

enum class RayOrder {
  kRows,
  kColumns,    ///< column by column below each lens
  kViewTiles,  ///< tiles of one directional view, whose rays are nearly parallel
};

/// Returns the value of the command-line flag for the order.
const char* to_string(RayOrder order);

}  // namespace lippmann
