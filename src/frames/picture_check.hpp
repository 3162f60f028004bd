// Warns of images that show nothing. Finds out why a frame has a single colour, or why its subject covers less than 0.1 % of
// the frame.
#pragma once

#include <string>

#include "frames/frame.hpp"

namespace lippmann {

/// Results of tracing 128 x 128 rays from the viewer through the frame of the display, as fractions of these rays.
struct SeenShare {
  double anything = 0.0;   ///< fraction of rays that hit a surface that is not fully transparent
  double subject = 0.0;    ///< fraction of rays that hit the subject of the view (FittedArray::is_subject)
  int only_instance = -1;  ///< the instance that all rays hit, or -1
};

/// Traces one small picture of the frame as the display's viewer sees it, and returns what its rays hit. Moves the stage's
/// device scene to the frame's time.
SeenShare look_at_frame(Stage& stage, int frame, const ThreadPool& pool);

/// Returns a warning with its reason in one sentence, or an empty string if the film shows something. `film` is the film of the
/// whole frame.
std::string doubt_about_picture(const Stage& stage, int frame, const SeenShare& seen, const Image& film);

}  // namespace lippmann
