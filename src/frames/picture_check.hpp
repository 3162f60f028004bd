// Warns of images that show nothing: a frame of one colour, or a subject that covers less than 0.1 % of it.
#pragma once

#include <string>

#include "frames/frame.hpp"

namespace lippmann {

/// Fractions of 128 x 128 rays from the viewer through the display.
struct SeenShare {
  double anything = 0.0;  ///< rays that hit a surface that is not fully transparent
  double subject = 0.0;   ///< rays that hit the subject of the view (FittedArray::is_subject)
  int only_instance = -1;
};

/// Moves the stage's device scene to the frame's time.
SeenShare look_at_frame(Stage& stage, int frame, const ThreadPool& pool);

/// Returns a warning for the user, or an empty string if the film shows something. `film` is the whole frame.
std::string doubt_about_picture(const Stage& stage, int frame, const SeenShare& seen, const Image& film);

}  // namespace lippmann
