// The order in which the pixels of a frame are traced; trace/strip_order.hpp has what follows from it.
#pragma once

namespace lippmann {

/// In which order the pixels of a frame are traced ("pixel-tracing style" in the paper); the picture is the same.
enum class RayOrder {
  kRows,       ///< pixel row by pixel row (the paper's horizontal style)
  kColumns,    ///< column by column below each lens (the paper's vertical style)
  kViewTiles,  ///< tiles of one directional view: neighbours in a packet share one direction
};

/// The order as a flag's value.
const char* to_string(RayOrder order);

}  // namespace lippmann
