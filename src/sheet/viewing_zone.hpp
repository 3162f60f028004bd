// Makes a test print that shows the viewing zone of a lenticular sheet. It has N views, each with its number and angle.
//
// Views are numbered 1 to N from left to right, and coloured from red over grey to blue. Seen from the right distance, the
// whole print shows one number. Where the number jumps from N to 1, a viewing zone ends and the next begins.
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

/// Returns a default number of views: an odd number up to 9, so that a view has about 2 pixels below each lens. Returns 2 if a
/// lens has fewer than 5 pixels.
int default_zone_views(const Display& sheet);

/// Returns the test print. Throws a usage Error naming `views` if there are more views than pixels below a lens. The result
/// does not depend on the number of threads.
ViewingZoneTest viewing_zone_test(const Display& sheet, int views, const ThreadPool& pool);

}  // namespace lippmann
