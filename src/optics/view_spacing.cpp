#include "optics/view_spacing.hpp"

#include <fmt/format.h>

#include "core/degrees.hpp"

namespace lippmann {

std::string view_spacing(const Optics& optics) {
  const auto* views = std::get_if<MultiView>(&optics.model);
  const int count = views ? views->columns * views->rows : 1;
  if (count < 2 || views->baseline_mm > 0.0f) return {};
  const double cone_deg = to_degrees(views->view_cone), steps = views->cone_ends_included ? count - 1.0 : count;
  return fmt::format("{} views {:.5g} degrees apart, the outermost {} the ends of {:.5g} degrees", count, cone_deg / steps,
                     views->cone_ends_included ? "at" : "half a step inside", cone_deg);
}

Optics with_cone_ends(Optics optics, bool ends_included) {
  std::visit(
      [&](auto& model) {
        if constexpr (requires { model.cone_ends_included; }) model.cone_ends_included = ends_included;
      },
      optics.model);
  return optics;
}

}  // namespace lippmann
