#include "lippmann/trace/ray_order.hpp"

#include <cstring>
#include <initializer_list>

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

bool parse(const char* text, RayOrder& order) {
  for (const RayOrder candidate : {RayOrder::kRows, RayOrder::kColumns, RayOrder::kViewTiles})
    if (std::strcmp(text, to_string(candidate)) == 0) {
      order = candidate;
      return true;
    }
  return false;
}

}  // namespace lippmann
