// Whether the display can resolve the depth of a scene: between its budget in front of the plane z = 0 and behind it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/fit_array.hpp"

namespace lippmann {

/// From where to where the scene reaches as shown: depth_front and depth_back of the FittedArray.
struct ShownDepth {
  float front_mm = 0.0f, back_mm = 0.0f;  ///< z of the display frame
  float budget_mm = kInfinity;            ///< depth_budget_mm (optics/optics.hpp)
  bool of_subject = false;                ///< what is left out as surroundings may reach farther

  float deepest_mm() const;
  /// Up to rounding: what was scaled to fit does.
  bool fits() const { return deepest_mm() <= 1.0001f * budget_mm; }
};

/// depth_scale: the parallax of the optics (with_parallax), shown depth / true depth.
ShownDepth shown_depth(const FittedArray& array, float units_per_mm, float depth_scale, const Optics& optics);

/// The depth scale at which it just fits; 1 where it does anyway.
float fitting_depth(const ShownDepth& true_depth);

/// "front_mm", "back_mm", "budget_mm" (null: none), "fits", "scale" (the depth scale), "summary".
nlohmann::ordered_json depth_json(const ShownDepth& shown, float depth_scale, const Optics& optics);

/// One sentence: the reach, whether it fits, and if not, by how much it is beyond and what becomes of it. Below a depth
/// scale of 1: how much of the depth is shown.
std::string depth_budget_sentence(const ShownDepth& shown, const Optics& optics, float depth_scale = 1.0f);

}  // namespace lippmann
