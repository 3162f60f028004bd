#include "render/frame_sink.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <utility>

#include "core/background.hpp"
#include "image/encode.hpp"

namespace lippmann {
namespace {

/// Writing a frame costs less than tracing one: half as many threads keep up with any scene.
int writing_threads(int rendering_threads) { return std::clamp(rendering_threads / 2, 1, 8); }

/// One more than are being written: the next is ready when a thread is.
int queue_capacity(int rendering_threads) { return writing_threads(rendering_threads) + 1; }

/// Adds the wall time of its life to a sum of nanoseconds.
class TimedWork {
 public:
  explicit TimedWork(std::atomic<std::int64_t>& sum) : sum_(sum) {}
  ~TimedWork() { sum_ += std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start_).count(); }
  TimedWork(const TimedWork&) = delete;
  TimedWork& operator=(const TimedWork&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  std::atomic<std::int64_t>& sum_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

struct FrameSink::Impl {
  Impl(const Settings& s, FinishedFrames& f)
      : settings(s), finished(f), queue(writing_threads(s.threads), queue_capacity(s.threads)) {}

  Settings settings;
  FinishedFrames& finished;
  std::atomic<std::int64_t> write_nanoseconds{0};
  BackgroundQueue queue;  ///< last: its threads use what is above

  void write(RenderedFrame& rendered) {
    const TimedWork timed(write_nanoseconds);
    FramePictures& pictures = rendered.pictures;
    if (settings.params.format == PictureFormat::kPng) pictures.codes = to_codes(pictures.film, settings.encoding);
    write_frame_files(settings.folder, rendered.report.frame, settings.params, settings.encoding, pictures);
  }
};

FrameSink::FrameSink(const Settings& settings, FinishedFrames& finished) : impl_(std::make_unique<Impl>(settings, finished)) {}
FrameSink::~FrameSink() = default;

void FrameSink::add(RenderedFrame rendered) {
  const auto shared = std::make_shared<RenderedFrame>(std::move(rendered));
  impl_->queue.submit([impl = impl_.get(), shared] { impl->write(*shared); },
                      [impl = impl_.get(), shared] { impl->finished.add(shared->report); });
}

void FrameSink::finish() { impl_->queue.finish(); }

double FrameSink::write_seconds() const { return 1e-9 * static_cast<double>(impl_->write_nanoseconds); }

int FrameSink::frames_in_memory(int threads) { return queue_capacity(threads) + 1; }

}  // namespace lippmann
