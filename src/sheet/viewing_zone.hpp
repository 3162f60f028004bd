// Makes a test print that shows the viewing zone of a lenticular sheet.
//
// The print has N views, each with its number and angle, from red on the left over grey to blue. From the right distance, the
// whole print shows one number. Where the number jumps from N to 1, the next viewing zone begins.
#pragma once

#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

struct ViewingZoneTest {
  Picture picture;
  std::vector<double> angles_deg;  ///< angles of the centres of the views, negative on the left
};

/// Returns a default number of views: odd, at most 9, with about 2 pixels per view. Returns 2 if a lens has fewer than 5
/// pixels.
int default_zone_views(const Display& sheet);

/// Throws a usage Error naming `views` if there are more views than pixels below a lens. The result does not depend on the
/// number of threads.
ViewingZoneTest viewing_zone_test(const Display& sheet, int views, const ThreadPool& pool);

}  // namespace lippmann
