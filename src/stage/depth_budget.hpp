// Compares the depth of a scene with the depth budget of the display in front of and behind the plane z = 0.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// The depth range of the scene as the display shows it: depth_front and depth_back of the FittedArray.
struct ShownDepth {
  float front_mm = 0.0f, back_mm = 0.0f;  ///< z in the display frame
  float budget_mm = kInfinity;            ///< see depth_budget_mm() (optics/optics.hpp)
  /// If true, this is the range of the subject only; surroundings may exceed it.
  bool of_subject = false;

  float deepest_mm() const;
  /// Returns whether the range is within the budget, with a tolerance for rounding.
  bool fits() const { return deepest_mm() <= 1.0001f * budget_mm; }
};

/// Returns the shown depth. `depth_scale` is shown depth / true depth (the parallax of the optics, see with_parallax()).
ShownDepth shown_depth(const FittedArray& array, float units_per_mm, float depth_scale, const Optics& optics);

/// Returns the largest depth scale at which the scene is within the budget, but at most 1.
float fitting_depth(const ShownDepth& true_depth);

/// Returns an object with "front_mm", "back_mm", "budget_mm" (null if unlimited), "fits", "scale" (the depth scale) and
/// "summary".
nlohmann::ordered_json depth_json(const ShownDepth& shown, float depth_scale, const Optics& optics);

/// Returns one sentence that states the range and whether it is within the budget. If not, the sentence states by how much the
/// range exceeds the budget and how this looks. If the depth scale is below 1, it also states which share of the depth is
/// shown.
std::string depth_budget_sentence(const ShownDepth& shown, const Optics& optics, float depth_scale = 1.0f);

}  // namespace lippmann
