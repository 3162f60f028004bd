// Compares the depth of a scene with the depth that the display can show sharply in front of and behind the plane z = 0 (the
// depth budget).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

struct ShownDepth {
  float front_mm = 0.0f, back_mm = 0.0f;
  float budget_mm = kInfinity;
  /// True if the range is that of the subject only; surroundings may exceed it.
  bool of_subject = false;

  float deepest_mm() const;
  bool fits() const { return deepest_mm() <= 1.0001f * budget_mm; }
};

/// `depth_scale` is shown depth / true depth.
ShownDepth shown_depth(const FittedArray& array, float units_per_mm, float depth_scale, const Optics& optics);

/// Returns the largest depth scale, at most 1, with which the scene is within the budget.
float fitting_depth(const ShownDepth& true_depth);

/// Returns "front_mm", "back_mm", "budget_mm" (null if unlimited), "fits", "scale" (the depth scale) and "summary".
nlohmann::ordered_json depth_json(const ShownDepth& shown, float depth_scale, const Optics& optics);

/// Returns a sentence on the range, on how excess depth looks, and on the depth scale if it is below 1.
std::string depth_budget_sentence(const ShownDepth& shown, const Optics& optics, float depth_scale = 1.0f);

}  // namespace lippmann
