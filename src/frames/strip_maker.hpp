// Renders frames in strips of rows, for stills that take too much time or memory in one process. The pixels of a strip have the
// same bits as in the whole frame.
#pragma once

#include "frames/frame.hpp"
#include "lippmann/frames/frame_params.hpp"

namespace lippmann {

class StripMaker {
 public:
  /// `params` must pass check_strips(). `stage`, `pool` and `context` must outlive this object. Nothing else may use the stage.
  StripMaker(Stage& stage, const FrameParams& params, int strips, const ThreadPool& pool, const Context& context);

  int strips() const { return strips_; }

  FilmRows rows_of(int strip) const;

  /// Renders one strip. Strips may be rendered in any order. The result is incomplete if the context is cancelled.
  RenderedFrame make(int frame, int strip);

 private:
  Stage& stage_;
  FrameParams params_;
  int strips_;
  const ThreadPool& pool_;
  const Context& context_;
};

/// Returns the highest number of strips; some rows are traced together and cannot be divided.
int most_strips(const Optics& optics);

/// Throws a usage Error if there are too few rows, or if a strip needs the pixels of the whole frame.
void check_strips(const FrameParams& params, const Optics& optics, int strips);

/// Adds times and rays, and combines error estimates. `rows` holds the number of rows of each strip.
FrameReport report_of_strips(const std::vector<FrameReport>& strips, const std::vector<int>& rows);

}  // namespace lippmann
