#include "frames/exact_frames.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "reuse/settled_blocks.hpp"
#include "trace/pixels_of_blocks.hpp"

namespace lippmann {
namespace {

// If copying blocks saves less than kLeastSpanSaving of the time, the next 16 frames are traced without copying. If this
// happens again, the number doubles, up to kLongestRest.
constexpr double kLeastSpanSaving = 0.02;
constexpr int kLongestRest = 256;

class ExactFrames final : public FrameMaker {
 public:
  ExactFrames(const MakerParts& parts, const CopySettled& reuse);

  RenderedFrame make(int frame) override;

 private:
  RenderedFrame key(int frame);
  RenderedFrame from_key(int frame);
  void mark_copied(const Shot& shot, std::span<const std::uint8_t> unsettled, FrameAovs& aovs) const;
  void judge(const FrameReport& in_between);

  MakerParts parts_;
  CopySettled reuse_;
  int last_frame_;
  SettledBlocks settled_;

  /// The key frame key_ is copied to the frames key_ + 1 ... key_ + span_ - 1.
  int key_ = 0, span_ = 0;
  Image film_;
  TouchedBlocks blocks_;

  // Measured times decide how long blocks are copied; they do not affect the images.
  /// CPU time of the last fully traced frame and of the last key frame; 0 if not measured yet.
  double full_seconds_ = 0.0, key_seconds_ = 0.0;
  int rest_ = 0;
  int next_rest_ = 16;
};

ExactFrames::ExactFrames(const MakerParts& parts, const CopySettled& reuse)
    : parts_(parts),
      reuse_(reuse),
      last_frame_(parts.stage.scene.timeline.frame_count - 1),
      settled_(parts.stage.scene, parts.stage.array.node, reuse.keyframes) {}

RenderedFrame ExactFrames::make(int frame) {
  if (frame > key_ && frame < key_ + span_) return from_key(frame);
  span_ = 0;
  const bool must = reuse_.keyframes.has_value();
  if (must || (full_seconds_ > 0.0 && rest_ == 0)) {
    blocks_.boxes = settled_.boxes(frame, last_frame_);
    if (SettledBlocks::can_settle(blocks_.boxes)) return key(frame);
  }
  rest_ = std::max(0, rest_ - 1);
  RenderedFrame rendered = render_frame(parts_.stage, parts_.sampling, frame, parts_.pool, parts_.context);
  full_seconds_ = rendered.report.cpu_seconds;
  return rendered;
}

RenderedFrame ExactFrames::key(int frame) {
  RenderedFrame rendered = render_frame(parts_.stage, parts_.sampling, frame, parts_.pool, parts_.context, &blocks_);
  if (parts_.context.cancelled) return rendered;
  rendered.report.kind = "key";
  key_seconds_ = rendered.report.cpu_seconds;
  key_ = frame;
  span_ = settled_.choose_span(blocks_, frame, last_frame_);
  if (span_ > 1)
    film_ = rendered.pictures.film;
  else
    rest_ = next_rest_, next_rest_ = std::min(2 * next_rest_, kLongestRest);
  return rendered;
}

RenderedFrame ExactFrames::from_key(int frame) {
  const FrameClock clock(parts_.pool);
  RenderedFrame rendered;
  const Moment moment = parts_.stage.moment_at(frame);
  rendered.pictures.film = film_;
  parts_.stage.device.update(moment.resolved, parts_.pool);
  const std::vector<std::uint8_t> unsettled = settled_.unsettled(blocks_, frame - key_);
  rendered.report.rays = trace_blocks(parts_.stage.shot(moment), trace_params(parts_.sampling, parts_.stage), unsettled,
                                      {parts_.pool, parts_.context}, rendered.pictures.film);
  rendered.pictures.aovs = wanted_aovs(parts_.sampling);
  mark_copied(parts_.stage.shot(moment), unsettled, rendered.pictures.aovs);
  rendered.report.frame = frame;
  rendered.report.kind = "in-between";
  const std::uint64_t samples = static_cast<std::uint64_t>(film_.width) * static_cast<std::uint64_t>(film_.height) *
                                static_cast<std::uint64_t>(samples_per_pixel(parts_.sampling));
  rendered.report.reused_pixels =
      (samples - rendered.report.rays.primary) / static_cast<std::uint64_t>(samples_per_pixel(parts_.sampling));
  clock.add_to(rendered.report);
  if (!reuse_.keyframes) judge(rendered.report);
  return rendered;
}

void ExactFrames::mark_copied(const Shot& shot, std::span<const std::uint8_t> unsettled, FrameAovs& aovs) const {
  set_provenance(Provenance::kCopied, film_size(shot), aovs);
  if (!aovs.wants(Aov::kProvenance)) return;
  std::vector<float>& codes = aovs[Aov::kProvenance].data;
  for_each_pixel_of_blocks(shot, parts_.sampling.order, unsettled,
                           [&](std::uint32_t pixel) { codes[pixel] = static_cast<float>(Provenance::kTraced); });
}

void ExactFrames::judge(const FrameReport& in_between) {
  const double span_seconds = key_seconds_ + (span_ - 1) * in_between.cpu_seconds;
  if (span_seconds < (1.0 - kLeastSpanSaving) * span_ * full_seconds_) {
    next_rest_ = 16;
    return;
  }
  span_ = 0;
  rest_ = next_rest_, next_rest_ = std::min(2 * next_rest_, kLongestRest);
}

}  // namespace

std::unique_ptr<FrameMaker> make_exact_frames(const MakerParts& parts, const CopySettled& reuse) {
  return std::make_unique<ExactFrames>(parts, reuse);
}

}  // namespace lippmann
