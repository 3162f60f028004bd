#include "lippmann/trace/ray_order.hpp"

namespace lippmann {

const char* to_string(RayOrder order) {
  switch (order) {
    case RayOrder::kRows:
      return "rows";
    case RayOrder::kColumns:
      return "columns";
    case RayOrder::kViewTiles:
      break;
  }
  return "view-tiles";
}

}  // namespace lippmann
