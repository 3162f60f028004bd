// Interpolated frames that keep to a PSNR (--reuse interpolate --min-psnr): key frames are traced, the others predicted from
// them and traced where they are uncertain (reuse/quality_floor.hpp).
//
// Whether that pays is told from counts (reuse/tracing_costs.hpp), never from a clock. An animation is cut into segments of
// kSegmentIntervals intervals, each of kDefaultKeyframes frames or as many as were asked for. In the first interval of a
// segment the middle frame is predicted, traced as a whole and compared: its errors tell what uncertainty means in the segment,
// and what the other frames will cost. If that pays, all of the segment has such intervals; if not, intervals half as long are
// tried, unless a length was asked for. If nothing pays, all frames of the segment are traced, at no further cost. In every
// interval the middle frame is made first; where it has to be traced as a whole after all, so have the others.
//
// What is tried first depends on the animation alone, and what comes of it as well, so that any part of an animation has the
// same bytes as in the whole.
#pragma once

#include <map>
#include <vector>

#include "frames/forward_source.hpp"
#include "frames/frame_maker.hpp"
#include "reuse/frame_plan.hpp"
#include "reuse/in_between.hpp"

namespace lippmann {

class ErrorBoundedFrames final : public FrameMaker {
 public:
  /// `reuse.min_psnr_db` is given.
  ErrorBoundedFrames(const MakerParts& parts, const Interpolate& reuse);

  RenderedFrame make(int frame) override;
  std::vector<FrameReport> sources() const override;

  static double bytes_kept_per_pixel();

  /// Frames for which it is found out together whether predicting pays.
  static int frames_per_segment(const Interpolate& reuse);

 private:
  struct Segment {
    int length = 0;     ///< frames from key to key; 0: all are traced
    Evidence evidence;  ///< what uncertainty means in it
  };

  /// Renders a frame, and whatever it depends on, into films_ or keys_.
  void render(int frame);
  void render_between(int frame, const FrameInterval& interval, const Evidence& learned);
  /// The segment of a frame. Tries it where that has not been done.
  const Segment& segment_of(int frame);
  Segment try_segment(int first);
  /// Traces the middle frame of an interval, which has such keys around it, and compares it with its prediction.
  FloorLesson learn(const FrameInterval& interval);
  /// Whether the frame in the middle of an interval, which is made first, was worth predicting.
  bool middle_holds(const FrameInterval& interval, const Evidence& learned);
  /// False: the frame had to be traced.
  bool predict_or_trace(int frame, const FrameInterval& interval, const Evidence& learned);
  void trace(int frame, const FrameReport& spent = {});
  const PointImage& key(int frame);
  void forget_before(int frame);
  RenderedFrame take(int frame);

  MakerParts parts_;
  Interpolate reuse_;
  int every_, last_frame_;
  InBetweenMaker maker_;
  std::map<int, ForwardSource> keys_;         ///< by frame
  std::map<int, RenderedFrame> films_;        ///< likewise: made, not taken yet
  std::map<int, Segment> segments_;           ///< by first frame
  std::map<int, bool> middle_holds_;          ///< by middle frame
  std::map<int, FrameReport> not_asked_for_;  ///< rendered because others depend on them, by frame
};

}  // namespace lippmann
