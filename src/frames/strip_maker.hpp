// Frames in strips of rows, each made by itself with the memory of its rows: for stills that one process would need too long
// for, or too much memory.
//
// A strip has the bits that its rows have in the whole frame.
#pragma once

#include "frames/frame.hpp"
#include "lippmann/frames/frame_params.hpp"

namespace lippmann {

class StripMaker {
 public:
  /// `params` passes check_strips(); `stage`, `pool` and `context` outlive this, and nothing else renders with the stage.
  StripMaker(Stage& stage, const FrameParams& params, int strips, const ThreadPool& pool, const Context& context);

  int strips() const { return strips_; }

  /// The rows of strip `strip` of a frame, from 0 at the top.
  FilmRows rows_of(int strip) const;

  /// Film and layers of these rows. In any order. Unfinished when the context was cancelled meanwhile.
  RenderedFrame make(int frame, int strip);

 private:
  Stage& stage_;
  FrameParams params_;
  int strips_;
  const ThreadPool& pool_;
  const Context& context_;
};

/// Into how many strips frames fall at most: rays are traced together in bands of rows, which stay whole.
int most_strips(const Optics& optics);

/// Throws a usage Error where frames cannot be made in so many strips: where rows need others, or are too few.
void check_strips(const FrameParams& params, const Optics& optics, int strips);

/// What a frame took as its strips did, and how good it is, which are those of a frame: `rows` of each, in the same order.
/// Neither is empty.
FrameReport report_of_strips(const std::vector<FrameReport>& strips, const std::vector<int>& rows);

}  // namespace lippmann
