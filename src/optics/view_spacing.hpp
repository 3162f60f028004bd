// The angular spacing of a quilt's views.
#pragma once

#include <string>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Describes the angle between the views of a cone, and the position of the outermost ones: "23 views 2.0455 degrees apart, the
/// outermost at the ends of 45 degrees". Empty for other optics.
std::string view_spacing(const Optics& optics);

/// Returns the optics with the outermost views of a cone at its ends, or half a step inside; other optics unchanged.
Optics with_cone_ends(Optics optics, bool ends_included);

}  // namespace lippmann
