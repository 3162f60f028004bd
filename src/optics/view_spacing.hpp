// How far apart the views of a quilt are.
#pragma once

#include <string>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the angle from view to view of a cone of views, and where in the cone the outermost stand: "23 views 2.0455 degrees
/// apart, the outermost at the ends of 45 degrees". Empty: other optics.
std::string view_spacing(const Optics& optics);

/// Returns the optics with the outermost of a cone of views at the ends of the cone, or half a step inside; others as they are.
Optics with_cone_ends(Optics optics, bool ends_included);

}  // namespace lippmann
