// The paper's interpolated animation: key frames are traced, the frames between them made from their points; straight from the
// two keys, or by halving (reuse/frame_plan.hpp). Of the frames that others are made from, only those on the way to the frame
// under way are kept.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "frames/forward_source.hpp"
#include "frames/frame_maker.hpp"
#include "image/spare_images.hpp"
#include "reuse/frame_plan.hpp"
#include "reuse/in_between.hpp"

namespace lippmann {

class ForwardFrames final : public FrameMaker {
 public:
  ForwardFrames(const MakerParts& parts, const Interpolate& reuse);

  RenderedFrame make(int frame) override;
  void recycle(Image film) override { spare_films_.give(std::move(film)); }
  std::vector<FrameReport> sources() const override;

  static double bytes_kept_per_pixel(const Interpolate& reuse);

 private:
  using Source = ForwardSource;

  Source between(int frame, const FrameInterval& interval, bool as_source);
  /// The intervals to go through until the frame, which is no key, is made from the ends of the last one.
  std::vector<FrameInterval> path_to(int frame) const;
  void keep_only_sources_of(int frame);
  const Source& key(int frame);
  const Source& add(Source source);

  MakerParts parts_;
  Interpolate reuse_;
  int every_, last_frame_;
  InBetweenMaker maker_;
  SpareImages spare_films_;
  std::map<int, Source> sources_;             ///< by frame
  std::map<int, FrameReport> not_asked_for_;  ///< rendered as sources only, by frame
};

}  // namespace lippmann
