// Cameras that a user states for files without cameras, and a warning if cameras of a file seem to be missing.
#pragma once

#include <string>
#include <vector>

#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Returns cameras with the stated baseline. If the light field has positions, the eyes are at these positions, scaled so that
/// their mean step equals the baseline. Otherwise they form a regular grid. The mean of the eyes is on the display's axis.
/// Throws a usage Error naming the parameter for lengths that are not positive, and Error naming `where` if all positions
/// coincide.
ViewCameras cameras_as_stated(const StatedCameras& stated, const LightField& field, const std::string& where);

/// Sets the cameras of a light field to cameras_as_stated(). Throws a usage Error naming "baseline" if its files state cameras.
void state_cameras(LightField& field, const StatedCameras& stated, const std::string& where);

/// Warns if views seem to be missing: the eyes lie on a regular grid, of which some places, at most a quarter, are empty.
/// `where`: name of the file with the cameras.
void warn_of_missing_cameras(const std::vector<Vec2d>& eyes, const std::string& where, const FormatOptions& options);

}  // namespace lippmann
