// Frames that are rendered strip by strip: each strip goes into a file of the folder, and frames are joined from these files.
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
    FrameAovs wanted;             ///< layers
    Vec2i film{0, 0};             ///< of a whole frame
    bool keeps_finished = false;  ///< strips that are there as they were recorded are not made again
    bool only_joins = false;      ///< no strip is made: one that is not there is an Error
  };

  /// A strip that was rendered and recorded.
  struct MadeStrip {
    StripNumber number;
    FrameReport report;
  };

  /// `folder`, `progress` and `context` outlive this; nothing else records in the folder while a strip or a frame is made.
  StrippedFrames(const StripMaker& strips, RenderFolder& folder, const Settings& settings, RunProgress& progress,
                 const Context& context);

  /// Renders those of the parts (parts_of) that are not there. Fewer where the context was cancelled meanwhile.
  void make_strips(const std::vector<int>& parts);

  /// Renders the strips that are not there, and joins all of them. Throws Error where one is not there.
  RenderedFrame make(int frame) override;

  /// What was rendered so far, in order.
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
