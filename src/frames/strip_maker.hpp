// Renders frames in strips of rows, for stills that take too much time or memory in a single process. Each strip is rendered
// separately and needs memory for its own rows only. The pixels of a strip have the same bits as in the whole frame.
#pragma once

#include "frames/frame.hpp"
#include "lippmann/frames/frame_params.hpp"

namespace lippmann {

class StripMaker {
 public:
  /// `params` must pass check_strips(). `stage`, `pool` and `context` must outlive this object. The stage must not be used by
  /// other renderers.
  StripMaker(Stage& stage, const FrameParams& params, int strips, const ThreadPool& pool, const Context& context);

  int strips() const { return strips_; }

  /// Returns the film rows of a strip. Strips are numbered from 0 at the top.
  FilmRows rows_of(int strip) const;

  /// Renders the film and the layers of one strip. Strips may be rendered in any order. The result is incomplete if the context
  /// is cancelled meanwhile.
  RenderedFrame make(int frame, int strip);

 private:
  Stage& stage_;
  FrameParams params_;
  int strips_;
  const ThreadPool& pool_;
  const Context& context_;
};

/// Returns the maximum number of strips of a frame. The number is limited because some rows are traced together and cannot be
/// divided.
int most_strips(const Optics& optics);

/// Throws a usage Error if frames cannot be rendered in `strips` strips. This is the case if there are too few rows, or if a
/// strip needs the pixels of the whole frame.
void check_strips(const FrameParams& params, const Optics& optics, int strips);

/// Combines the reports of a frame's strips: adds their times and rays, and combines their error estimates. `rows` holds the
/// number of rows of each strip, in the same order. Neither argument may be empty.
FrameReport report_of_strips(const std::vector<FrameReport>& strips, const std::vector<int>& rows);

}  // namespace lippmann
