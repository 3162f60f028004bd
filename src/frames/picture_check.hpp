// Warns of pictures that show nothing: why a frame is of one colour all over, or why its subject covers less than 0.1 % of it.
#pragma once

#include <string>

#include "frames/frame.hpp"

namespace lippmann {

/// Shares of 128 x 128 rays from the viewer through the display's frame, by what they hit.
struct SeenShare {
  double anything = 0.0;   ///< share of rays that meet a surface which is not fully transparent
  double subject = 0.0;    ///< share that meet what the view is about (FittedArray::is_subject)
  int only_instance = -1;  ///< the one that all rays meet; -1: there is none
};

/// Moves the stage's device scene to the frame's time.
SeenShare look_at_frame(Stage& stage, int frame, const ThreadPool& pool);

/// One sentence for a warning, with the reason; empty for a film that shows something. film: of the whole frame.
std::string doubt_about_picture(const Stage& stage, int frame, const SeenShare& seen, const Image& film);

}  // namespace lippmann
