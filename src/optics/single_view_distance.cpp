#include "optics/single_view_distance.hpp"

namespace lippmann {

Optics with_single_view_distance(Optics optics, float distance_mm) {
  if (auto* view = std::get_if<SingleView>(&optics.model)) view->distance_mm = distance_mm;
  return optics;
}

}  // namespace lippmann
