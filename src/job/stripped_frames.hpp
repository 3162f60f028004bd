// Renders frames in strips, which are files of the folder, and joins frames from these files.
#pragma once

#include <vector>

#include "folder/render_folder.hpp"
#include "frames/frame_maker.hpp"
#include "frames/strip_maker.hpp"
#include "job/run_progress.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

class StrippedFrames final : public FrameMaker {
 public:
  struct Settings {
    FrameAovs wanted;
    Vec2i film{0, 0};             ///< size of a whole frame
    bool keeps_finished = false;  ///< keeps strips that match the journal
    bool only_joins = false;      ///< renders no strip; a missing strip is an Error
  };

  struct MadeStrip {
    StripNumber number;
    FrameReport report;
  };

  /// `folder`, `progress` and `context` must outlive this object. Nothing else may write to the folder's journal while
  /// a strip or a frame is made.
  StrippedFrames(const StripMaker& strips, RenderFolder& folder, const Settings& settings, RunProgress& progress,
                 const Context& context);

  /// Renders the missing strips of `parts` (see parts_of()). Stops early if the context is cancelled.
  void make_strips(const std::vector<int>& parts);

  /// Renders the missing strips of a frame and joins all strips. Throws Error if a strip is missing afterwards.
  RenderedFrame make(int frame) override;

  const std::vector<MadeStrip>& made() const { return made_; }

 private:
  RenderedFrame join(int frame) const;
  bool make_strip(int frame, int strip);

  StripMaker strips_;
  RenderFolder& folder_;
  Settings settings_;
  RunProgress& progress_;
  const Context& context_;
  std::vector<MadeStrip> made_;
};

}  // namespace lippmann
