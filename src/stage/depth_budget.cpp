#include "stage/depth_budget.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace lippmann {
namespace {

/// Describes the appearance of a depth that exceeds the depth budget by the factor `times`.
std::string beyond(float times, const Optics& optics) {
  if (view_tiles(optics)) return fmt::format("neighbouring views are {:.1f} pixels apart and seen as steps", times);
  return fmt::format("a pixel is as wide as {:.1f} lenses", times);
}

const char* whose(const ShownDepth& shown) { return shown.of_subject ? "The subject" : "The scene"; }

std::string fitted_sentence(const ShownDepth& shown, float depth_scale) {
  return fmt::format(
      "{} reaches from {:+.1f} mm to {:+.1f} mm, beyond the depth budget of {:.1f} mm on either side. Its depth is scaled to "
      "{:.3g} %: {:+.1f} mm to {:+.1f} mm.",
      whose(shown), shown.back_mm / depth_scale, shown.front_mm / depth_scale, shown.budget_mm,
      100.0 * static_cast<double>(depth_scale), shown.back_mm, shown.front_mm);
}

}  // namespace

float ShownDepth::deepest_mm() const { return std::max(std::abs(front_mm), std::abs(back_mm)); }

ShownDepth shown_depth(const FittedArray& array, float units_per_mm, float depth_scale, const Optics& optics) {
  const float mm = depth_scale / units_per_mm;
  return {array.depth_front * mm, array.depth_back * mm, depth_budget_mm(optics), array.leaves_out_surroundings};
}

float fitting_depth(const ShownDepth& true_depth) {
  return true_depth.fits() ? 1.0f : true_depth.budget_mm / true_depth.deepest_mm();
}

std::string depth_budget_sentence(const ShownDepth& shown, const Optics& optics, float depth_scale) {
  if (depth_scale < 1.0f) return fitted_sentence(shown, depth_scale);
  const std::string reach =
      fmt::format("{} reaches from {:+.1f} mm to {:+.1f} mm", whose(shown), shown.back_mm, shown.front_mm);
  const float budget = shown.budget_mm, deepest = shown.deepest_mm();
  if (std::isinf(budget)) return reach + (is_single_view(optics) ? "; a single view" : "; a camera") + " has no depth budget.";
  if (shown.fits()) return reach + fmt::format(", within the depth budget of {:.1f} mm on either side.", budget);
  return reach + fmt::format(", {:.1f} mm beyond the depth budget of {:.1f} mm on either side: at {:.1f} mm {}.",
                             deepest - budget, budget, deepest, beyond(deepest / budget, optics));
}

nlohmann::ordered_json depth_json(const ShownDepth& shown, float depth_scale, const Optics& optics) {
  using Json = nlohmann::ordered_json;
  return {{"front_mm", shown.front_mm},
          {"back_mm", shown.back_mm},
          {"budget_mm", std::isfinite(shown.budget_mm) ? Json(shown.budget_mm) : Json(nullptr)},
          {"fits", shown.fits()},
          {"scale", depth_scale},
          {"summary", depth_budget_sentence(shown, optics, depth_scale)}};
}

}  // namespace lippmann
