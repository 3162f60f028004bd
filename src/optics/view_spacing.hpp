#pragma once

#include <string>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns a description of the views of a cone, such as "23 views 2.0455 degrees apart, the outermost at the ends of 45
/// degrees". Returns an empty text for other optics.
std::string view_spacing(const Optics& optics);

/// Places the outermost views of a cone at the ends of the cone if `ends_included`, otherwise half a view step inside the cone.
/// Returns other optics unchanged.
Optics with_cone_ends(Optics optics, bool ends_included);

}  // namespace lippmann
