#include "bench/reuse_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "frames/frame_maker.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_params.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "reuse/frame_plan.hpp"

namespace lippmann::bench {
namespace {

constexpr int kTurn = 8;

struct TracedFrame {
  Image8 codes;
  double seconds;
};

using TracedFrames = std::map<int, TracedFrame>;

/// Returns the PSNR in dB between `test` and `reference` over the pixels that differ between `a` and `b`.
std::optional<double> psnr_where_they_differ(const Image8& a, const Image8& b, const Image8& reference, const Image8& test) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t p = 0; p < a.rgb.size(); p += 3) {
    if (std::equal(&a.rgb[p], &a.rgb[p] + 3, &b.rgb[p])) continue;
    ++count;
    for (std::size_t c = p; c < p + 3; ++c) {
      const double difference = reference.rgb[c] - test.rgb[c];
      sum += difference * difference;
    }
  }
  if (count == 0) return std::nullopt;
  return psnr_db(sum / (3.0 * static_cast<double>(count)));
}

Image8 blend(const Image8& a, const Image8& b) {
  Image8 mean = a;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) mean.rgb[i] = static_cast<unsigned char>((a.rgb[i] + b.rgb[i] + 1) / 2);
  return mean;
}

double blend_psnr(const Image8& a, const Image8& b, const Image8& reference) {
  const Image8 mean = blend(a, b);
  double sum = 0.0;
  for (std::size_t i = 0; i < mean.rgb.size(); ++i) {
    const double difference = mean.rgb[i] - reference.rgb[i];
    sum += difference * difference;
  }
  return psnr_db(sum / static_cast<double>(mean.rgb.size()));
}

ReuseFrame compare(const RenderedFrame& made, const TracedFrames& traced, const FrameInterval& keys, Encoding encoding,
                   bool exactly) {
  ReuseFrame result;
  result.frame = made.report.frame;
  result.key = made.report.kind != "in-between";
  result.seconds = made.report.cpu_seconds;
  result.missed_pixels = made.report.missed_pixels;
  const TracedFrame& truth = traced.at(result.frame);
  result.traced_seconds = truth.seconds;
  const Image8 codes = to_codes(made.pictures.film, encoding);
  result.likeness = measure_difference(truth.codes, codes);
  if ((exactly || result.key) && !result.likeness.identical)
    throw Error("bench", fmt::format("frame {} ({}{}) should be exact, but differs from the traced one: PSNR {:.2f} dB",
                                     result.frame, made.report.kind, exactly ? ", reuse exact" : "", result.likeness.psnr_db));
  if (result.key) return result;
  const Image8 &before = traced.at(keys.first).codes, &after = traced.at(keys.last).codes;
  result.moving_psnr = psnr_where_they_differ(before, after, truth.codes, codes);
  result.blend_psnr = blend_psnr(before, after, truth.codes);
  return result;
}

template <class Fn>
std::optional<double> mean_of_in_betweens(const std::vector<ReuseFrame>& frames, const Fn& value) {
  double sum = 0.0;
  int count = 0;
  for (const ReuseFrame& frame : frames) {
    const std::optional<double> v = frame.key ? std::nullopt : std::optional<double>(value(frame));
    if (v && std::isfinite(*v)) sum += *v, ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace

double ReuseRun::traced_seconds() const {
  double sum = 0.0;
  for (const ReuseFrame& frame : frames) sum += frame.traced_seconds;
  return sum;
}

double ReuseRun::seconds() const {
  double sum = 0.0;
  for (const ReuseFrame& frame : frames) sum += frame.seconds;
  return sum;
}

double ReuseRun::saving_in_between() const {
  const auto traced = mean_of_in_betweens(frames, [](const ReuseFrame& f) { return f.traced_seconds; });
  const auto made = mean_of_in_betweens(frames, [](const ReuseFrame& f) { return f.seconds; });
  return traced ? 1.0 - *made / *traced : 0.0;
}

std::optional<double> ReuseRun::mean_psnr() const {
  return mean_of_in_betweens(frames, [](const ReuseFrame& f) { return f.likeness.psnr_db; });
}

std::optional<double> ReuseRun::min_psnr() const {
  double least = kInfinity;
  for (const ReuseFrame& frame : frames)
    if (!frame.key) least = std::min(least, frame.likeness.psnr_db);
  return std::isfinite(least) ? std::optional(least) : std::nullopt;
}

std::optional<double> ReuseRun::mean_moving_psnr() const {
  return mean_of_in_betweens(frames, [](const ReuseFrame& f) { return f.moving_psnr.value_or(kInfinity); });
}

std::optional<double> ReuseRun::mean_blend_psnr() const {
  return mean_of_in_betweens(frames, [](const ReuseFrame& f) { return f.blend_psnr; });
}

double ReuseRun::mean_ssim() const {
  return mean_of_in_betweens(frames, [](const ReuseFrame& f) { return f.likeness.ssim; }).value_or(1.0);
}

double ReuseRun::missed_share() const {
  const auto missed = mean_of_in_betweens(frames, [](const ReuseFrame& f) { return static_cast<double>(f.missed_pixels); });
  return missed.value_or(0.0) / static_cast<double>(pixels);
}

namespace {

/// Throws interrupted() if the context is cancelled, because frames that were stopped half-way must not be compared.
void stop_if_cancelled(const Context& context) {
  if (context.cancelled) throw interrupted();
}

std::vector<ReuseRun> run_round(Stage& stage, const BenchAnimation& animation, const std::vector<ReuseMethod>& methods,
                                const Request& request, const ThreadPool& pool, const Context& context) {
  const Encoding encoding = stage.scene.encoding;
  const int last_of_all = stage.scene.timeline.frame_count - 1, end = animation.first + animation.count;
  std::vector<std::unique_ptr<FrameMaker>> makers;
  std::vector<ReuseRun> runs;
  const Panel& panel = stage.placed.optics.panel;
  for (const ReuseMethod& method : methods) {
    makers.push_back(make_frame_maker(stage, frame_params(ResolvedJob(method.params)), pool, context));
    const std::size_t pixels = static_cast<std::size_t>(panel.width) * static_cast<std::size_t>(panel.height);
    runs.push_back({animation.name, method.name, method.params.reuse.keyframes.value_or(kDefaultKeyframes), pixels, {}});
  }
  render_frame(stage, animation.params.sampling, animation.first, pool, context);
  TracedFrames traced;
  for (int first = animation.first; first < end; first += kTurn) {
    begin_step(request, context, fmt::format("{}: frames {} to {}", animation.name, first, std::min(first + kTurn, end) - 1));
    for (int frame = first; frame <= std::min(first + kTurn, last_of_all); ++frame) {
      if (traced.contains(frame)) continue;
      const RenderedFrame rendered = render_frame(stage, animation.params.sampling, frame, pool, context);
      stop_if_cancelled(context);
      traced[frame] = {to_codes(rendered.pictures.film, encoding), rendered.report.cpu_seconds};
    }
    for (std::size_t m = 0; m < methods.size(); ++m)
      for (int frame = first; frame < std::min(first + kTurn, end); ++frame) {
        const FrameInterval keys = key_interval(frame, runs[m].keyframes, last_of_all);
        RenderedFrame made = makers[m]->make(frame);
        stop_if_cancelled(context);
        runs[m].frames.push_back(compare(made, traced, keys, encoding, methods[m].params.reuse.choice == ReuseChoice::kCopy));
        makers[m]->recycle(std::move(made.pictures.film));
      }
    traced.erase(traced.begin(), traced.lower_bound(first + kTurn));
  }
  return runs;
}

}  // namespace

std::vector<ReuseRun> run_reuse(const BenchAnimation& animation, const std::vector<ReuseMethod>& methods,
                                const Request& request, const Context& context, int rounds) {
  const ThreadPool pool(resolved_threads(context));
  JobStage stage(ResolvedJob(animation.params), pool, context);
  std::vector<ReuseRun> runs = run_round(stage, animation, methods, request, pool, context);
  for (int round = 1; round < rounds; ++round) {
    const std::vector<ReuseRun> again = run_round(stage, animation, methods, request, pool, context);
    for (std::size_t m = 0; m < runs.size(); ++m)
      for (std::size_t f = 0; f < runs[m].frames.size(); ++f) {
        ReuseFrame& frame = runs[m].frames[f];
        frame.seconds = std::min(frame.seconds, again[m].frames[f].seconds);
        frame.traced_seconds = std::min(frame.traced_seconds, again[m].frames[f].traced_seconds);
      }
  }
  return runs;
}

}  // namespace lippmann::bench
