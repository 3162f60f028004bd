#include "job/frame_sink.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/background.hpp"
#include "core/json_text.hpp"
#include "image/read_image.hpp"
#include "layout/cameras.hpp"
#include "layout/quilt_side_file.hpp"
#include "lippmann/core/version.hpp"
#include "lippmann/image/encode.hpp"
#include "optics/optics_json.hpp"

namespace lippmann {
namespace {

/// What EXR files say of the render, for those who get them without its report.
std::vector<ExrAttribute> about_render(const FrameSink::Settings& settings) {
  std::vector<ExrAttribute> about{{"lippmann.version", version()}, {"lippmann.scene", settings.params.scene.name}};
  if (!settings.optics) return about;
  about.push_back({"lippmann.optics", json_to_text(optics_json(*settings.optics), -1)});
  about.push_back({"lippmann.depth_scale", fmt::format("{}", settings.depth_scale)});
  if (const auto rendered = rendered_views(*settings.optics)) {
    const ViewGrid& grid = rendered->film.grid;
    about.push_back({"lippmann.views", std::to_string(grid.columns) + "x" + std::to_string(grid.rows)});
  }
  return about;
}

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

/// The codes of the PNG itself: a video is the same whether its frames come from the film or from kept pictures.
bool needs_codes(PictureFormat format, const RenderParams& params) {
  return format == PictureFormat::kPng || format == PictureFormat::kTiff || !params.output.video.empty();
}

}  // namespace

VideoOptions video_options(const RenderParams& params, const std::string& file, double frames_per_second) {
  VideoOptions options{.rate = frame_rate(frames_per_second), .codec = params.output.video_codec, .crf = params.output.crf};
  if (!params.output.video_codec && std::filesystem::path(file).extension() == ".mkv") options.crf.reset();  // it loses nothing
  return options;
}

struct FrameSink::Impl {
  Impl(const Settings& s, FinishedFrames& f)
      : settings(s), finished(f), queue(writing_threads(s.threads), queue_capacity(s.threads)) {
    for (const std::string& video : s.videos)
      videos.push_back(std::make_unique<VideoWriter>(video, video_options(s.params, video, s.frames_per_second)));
  }

  Settings settings;
  FinishedFrames& finished;
  const std::vector<ExrAttribute> about = about_render(settings);
  std::vector<std::unique_ptr<VideoWriter>> videos;
  std::map<int, Precompensation> precompensated;
  std::atomic<std::int64_t> write_nanoseconds{0};
  BackgroundQueue queue;  ///< last: its threads use what is above

  /// Returns what was written. Its checksums are taken here, beside rendering, while the bytes are still in memory.
  FileRecords write(RenderedFrame& rendered) {
    const TimedWork timed(write_nanoseconds);
    FramePictures& pictures = rendered.pictures;
    Image as_traced;
    const Tone tone = tone_of(settings.params);
    const bool keeps_light = settings.layout.names().format == PictureFormat::kExr;
    const bool has_alpha = pictures.aovs.wants(Aov::kAlpha);
    if (!keeps_light && has_alpha) divide_by_alpha(pictures.aovs[Aov::kAlpha], pictures.film);
    if (!keeps_light) apply_tone(tone, pictures.film);
    if (!settings.layout.joins_sub_pixels()) undo_crosstalk_of(rendered);
    if (settings.layout.moves()) {
      as_traced = std::exchange(pictures.film, settings.layout.arrange(pictures.film));
      settings.layout.arrange(pictures.aovs);
    }
    if (settings.layout.joins_sub_pixels()) undo_crosstalk_of(rendered);
    if (needs_codes(settings.layout.names().format, settings.params))
      pictures.codes =
          keeps_light && !tone.is_identity() ? toned_codes(tone, pictures.film) : to_codes(pictures.film, settings.encoding);
    if (has_alpha && !pictures.codes.rgb.empty()) pictures.codes.alpha = alpha_codes(pictures.aovs[Aov::kAlpha]);
    std::vector<std::filesystem::path> files =
        write_frame_files(settings.folder, settings.layout.names(), rendered.report.frame, settings.params, settings.encoding,
                          settings.layout.pixels_per_mm(), pictures, about);
    if (const auto& quilt = settings.layout.quilt()) {
      const std::filesystem::path picture = files.front();
      write_quilt_side_file(picture, {*quilt, quilt->tiles.count()});
      files.push_back(quilt_side_path(picture));
    }
    const FileRecords records = records_of(settings.folder, files);
    if (settings.done_with) settings.done_with(settings.layout.moves() ? std::move(as_traced) : std::move(pictures.film));
    pictures.film = {};
    pictures.aovs = {};
    return records;
  }

  /// Videos beside pictures that keep the light.
  Image8 toned_codes(const Tone& tone, Image film) const {
    apply_tone(tone, film);
    return to_codes(film, settings.encoding);
  }

  void undo_crosstalk_of(RenderedFrame& rendered) const {
    if (!settings.crosstalk_to_undo) return;
    rendered.report.precompensation =
        undo_crosstalk(*settings.optics, *settings.crosstalk_to_undo, settings.encoding, rendered.pictures.film);
  }

  void record(const FrameReport& report, const FileRecords& files) {
    if (report.precompensation) precompensated[report.frame] = *report.precompensation;
    finished.add(report, files);
    if (!settings.written) return;
    std::uintmax_t bytes = 0;
    for (const auto& [name, sum] : files) bytes += sum.bytes;
    settings.written(report.frame, bytes);
  }

  void add_to_videos(const Image8& codes) {
    const TimedWork timed(write_nanoseconds);
    for (const auto& video : videos) video->add_frame(codes);
  }
};

FrameSink::FrameSink(const Settings& settings, FinishedFrames& finished) : impl_(std::make_unique<Impl>(settings, finished)) {}
FrameSink::~FrameSink() = default;

void FrameSink::add(RenderedFrame rendered) {
  const auto shared = std::make_shared<RenderedFrame>(std::move(rendered));
  const auto files = std::make_shared<FileRecords>();
  impl_->queue.submit([impl = impl_.get(), shared, files] { *files = impl->write(*shared); },
                      [impl = impl_.get(), shared, files] {
                        impl->record(shared->report, *files);
                        impl->add_to_videos(shared->pictures.codes);
                      });
}

void FrameSink::add_kept(int frame) {
  if (impl_->videos.empty()) return;
  const auto codes = std::make_shared<Image8>();
  const auto path = picture_paths(impl_->settings.folder, impl_->settings.layout.names(), frame).front();
  impl_->queue.submit([codes, path] { *codes = read_image8(path); },
                      [impl = impl_.get(), codes] { impl->add_to_videos(*codes); });
}

void FrameSink::wait() { impl_->queue.finish(); }

void FrameSink::finish_videos() {
  const TimedWork timed(impl_->write_nanoseconds);
  for (const auto& video : impl_->videos) video->finish();
}

const std::map<int, Precompensation>& FrameSink::precompensated() const { return impl_->precompensated; }

double FrameSink::write_seconds() const { return 1e-9 * static_cast<double>(impl_->write_nanoseconds); }

int FrameSink::frames_in_memory(int threads) { return queue_capacity(threads) + 1; }

}  // namespace lippmann
