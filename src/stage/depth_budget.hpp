// Compares the depth of a scene with the depth budget of the display in front of and behind the plane z = 0.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// The depth range of the scene as shown: depth_front and depth_back of the FittedArray.
struct ShownDepth {
  float front_mm = 0.0f, back_mm = 0.0f;  ///< z in the display frame
  float budget_mm = kInfinity;            ///< depth_budget_mm (optics/optics.hpp)
  bool of_subject = false;                ///< the range is that of the subject only; surroundings may exceed it

  float deepest_mm() const;
  /// Returns whether the range is within the budget, with a tolerance for rounding.
  bool fits() const { return deepest_mm() <= 1.0001f * budget_mm; }
};

/// Returns the shown depth. depth_scale: parallax of the optics (with_parallax), shown depth / true depth.
ShownDepth shown_depth(const FittedArray& array, float units_per_mm, float depth_scale, const Optics& optics);

/// Returns the depth scale at which the scene just fits, or 1 if it fits anyway.
float fitting_depth(const ShownDepth& true_depth);

/// Returns an object with "front_mm", "back_mm", "budget_mm" (null: unlimited), "fits", "scale" (the depth scale) and
/// "summary".
nlohmann::ordered_json depth_json(const ShownDepth& shown, float depth_scale, const Optics& optics);

/// Returns one sentence: the range, whether it fits, and otherwise by how much it exceeds the budget and with what effect. For
/// a depth scale below 1, also the share of the depth that is shown.
std::string depth_budget_sentence(const ShownDepth& shown, const Optics& optics, float depth_scale = 1.0f);

}  // namespace lippmann
