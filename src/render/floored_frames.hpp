// Interpolated frames that keep to a PSNR (--reuse forward --min-psnr): key frames are traced, the others predicted from them
// and traced where they are doubted (reuse/quality_floor.hpp).
//
// Without an interval between keys asked for, it follows from what turns out to be worth predicting, by halving: every
// kDefaultKeyframes-th frame is a key; of the frames between two keys the middle one is tried first. If it holds with little
// enough traced, the others are made from the same two keys. If not, it is traced as a whole, becomes a key itself, and both
// halves are tried in the same way. If next to nothing of it could be trusted, as at a cut, the frames between these keys are
// all traced. What is tried first depends on the animation alone, and what comes of it as well, so that any part of an
// animation has the same bytes as in the whole; nothing depends on how long anything takes.
#pragma once

#include <map>
#include <vector>

#include "render/forward_source.hpp"
#include "render/frame_maker.hpp"
#include "reuse/frame_plan.hpp"
#include "reuse/in_between.hpp"

namespace lippmann {

class FlooredFrames final : public FrameMaker {
 public:
  /// `params.min_psnr_db` is given.
  FlooredFrames(Stage& stage, const RenderParams& params, const ThreadPool& pool, const Context& context);

  RenderedFrame make(int frame) override;
  std::vector<FrameReport> sources() const override;

  static double bytes_kept_per_pixel();

 private:
  /// What came of the middle frame of an interval.
  enum class Verdict { kHolds, kSplits, kHopeless };

  struct Attempt {
    RenderedFrame frame;
    double share_to_trace = 1.0;
    bool holds = false;
  };

  /// Renders a frame, and whatever it depends on, into films_ or keys_.
  void render(int frame);
  Verdict verdict_on_middle(const FrameInterval& interval);
  Verdict try_middle(const FrameInterval& interval);
  Attempt predict(int frame, const FrameInterval& interval);
  /// Predicted, or where that does not hold, traced.
  void predict_or_trace(int frame, const FrameInterval& interval);
  void trace(int frame, const FrameReport& spent);
  const PointImage& key(int frame, const FrameReport& spent = {});
  void forget_before(int frame);
  RenderedFrame take(int frame);

  Stage& stage_;
  const RenderParams& params_;
  const ThreadPool& pool_;
  const Context& context_;
  int every_, last_frame_;
  InBetweenMaker maker_;
  std::map<int, ForwardSource> keys_;         ///< by frame
  std::map<int, RenderedFrame> films_;        ///< likewise: made, not taken yet
  std::map<int, Verdict> verdicts_;           ///< by middle frame
  std::map<int, FrameReport> not_asked_for_;  ///< rendered because others depend on them, by frame
};

}  // namespace lippmann
