// What a frame of shared light gets where it errs by more than it may.
#pragma once

#include "radiance/frame_errors.hpp"

namespace lippmann {

struct Remedy {
  bool finer_pixels = false;  ///< more samples where these scatter
  bool more_edges = false;    ///< more edges of light are left to paths
  bool more_updates = false;  ///< more updates of the cache
};

/// Pixels that are noisy where the light is right need more samples, and no better cells. Where means err, edges are the
/// likelier cause, and cost no updates. left: the error that is to be mended; edges: left to paths now.
Remedy remedy_for(const FrameErrors& errors, const FrameError& left, const FrameError& may, EdgesToPaths edges);

/// Whether only pixels err by too much.
bool is_of_pixels(const FrameErrors& errors, const FrameError& left, const FrameError& may);

/// Whether an attempt is worth another: it has left clearly less of what was too much. More edges are given a second chance, as
/// these alone may not do.
bool has_helped(const Remedy& remedy, const FrameErrors& errors, const FrameError& before, const FrameError& now);

/// Whether errors are beyond what mending could make up for.
bool is_hopeless(const FrameError& left, const FrameError& may);

/// Whether a frame has over twice the error that it may have. A history's first frame that has less stays as it is: to trace
/// it, too, would cost a small still two to three times what paths take.
bool is_far_off(const FrameError& found, const FrameError& may);

}  // namespace lippmann
