// The order in which the pixels of a frame are traced. trace/strip_order.hpp implements it.
#pragma once

namespace lippmann {

/// The order in which the pixels of a frame are traced ("pixel-tracing style" in the paper). It does not change the image.
enum class RayOrder {
  kRows,       ///< row by row; "horizontal" in the paper
  kColumns,    ///< column by column below each lens; "vertical" in the paper
  kViewTiles,  ///< tiles of one directional view: the rays of a packet share one direction
};

/// Returns the order's name as a flag value.
const char* to_string(RayOrder order);

}  // namespace lippmann
