#include "folder/frame_sink.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <utility>
#include <vector>

#include "core/background.hpp"
#include "folder/develop_frame.hpp"
#include "folder/frame_files.hpp"
#include "formats/lens_grid_file.hpp"
#include "formats/quilt_side_file.hpp"
#include "formats/rgbd_side_file.hpp"
#include "image/read_image.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

/// Writing costs less than tracing, so half the number of rendering threads suffices.
int writing_threads(int rendering_threads) { return std::clamp(rendering_threads / 2, 1, 8); }

/// The queue holds one frame more than there are writing threads, so that no thread waits for its next frame.
int queue_capacity(int rendering_threads) { return writing_threads(rendering_threads) + 1; }

/// Adds the wall time between its construction and its destruction to a sum of nanoseconds.
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
  Impl(const Settings& s, RenderFolder& f)
      : settings(s),
        folder(f),
        files{f.path(), s.layout.names(), s.layout.format(), s.pictures.exr_pixels, s.encoding, s.layout.pixels_per_mm(),
              s.about,  s.writing,        s.one_set},
        queue(writing_threads(s.threads), queue_capacity(s.threads)) {
    for (const VideoFile& video : s.videos) videos.push_back(std::make_unique<VideoWriter>(video.path, video.options));
  }

  Settings settings;
  RenderFolder& folder;
  const FrameFiles files;
  std::vector<std::unique_ptr<VideoWriter>> videos;
  std::map<int, Precompensation> precompensated;
  int first_frame = -1;  ///< first frame of the videos; -1: no frame has been added
  std::atomic<std::int64_t> write_nanoseconds{0};
  BackgroundQueue queue;  ///< the last member, because its threads use the other members

  /// Returns the records of the files. Checksums are computed here, while the bytes are still in memory.
  FileRecords write(RenderedFrame& rendered) {
    const TimedWork timed(write_nanoseconds);
    Image as_traced = develop(rendered);
    const std::vector<std::filesystem::path> written = write_files(rendered);
    const FileRecords records = records_of(files.folder, written);
    if (settings.layout.light_field() && !videos.empty()) rendered.pictures.codes = read_new_image8(written.front());
    if (settings.done_with)
      settings.done_with(settings.layout.moves() ? std::move(as_traced) : std::move(rendered.pictures.film));
    rendered.pictures.film = {};
    rendered.pictures.aovs = {};
    return records;
  }

  bool keeps_light() const { return files.format == PictureFormat::kExr; }

  /// Videos are made from 8-bit samples, so that their bytes do not depend on whether a frame was just rendered or was read
  /// from the file of an earlier run.
  bool needs_codes() const {
    // Light-field formats convert pictures to 8 bits themselves. Videos read these samples from the files.
    if (settings.layout.light_field()) return false;
    return files.format == PictureFormat::kPng || files.format == PictureFormat::kTiff || !videos.empty();
  }

  /// Develops the film in place. Returns the old buffer of the film if the picture gets a new one.
  Image develop(RenderedFrame& rendered) const {
    FramePictures& pictures = rendered.pictures;
    const Tone tone = tone_of(settings.pictures);
    Image as_traced = develop_frame(
        {settings.layout, settings.optics, tone, settings.encoding, settings.crosstalk_to_undo, keeps_light()}, rendered);
    if (needs_codes())
      pictures.codes =
          keeps_light() && !tone.is_identity() ? toned_codes(tone, pictures.film) : to_codes(pictures.film, settings.encoding);
    if (pictures.aovs.wants(Aov::kAlpha) && !pictures.codes.rgb.empty())
      pictures.codes.alpha = alpha_codes(pictures.aovs[Aov::kAlpha]);
    return as_traced;
  }

  std::vector<std::filesystem::path> write_files(const RenderedFrame& rendered) const {
    const int frame = rendered.report.frame;
    if (const LightFieldFormat* format = settings.layout.light_field())
      return write_light_field_files(files, frame, *format, settings.optics, rendered.pictures);
    std::vector<std::filesystem::path> written = write_frame_files(files, frame, rendered.pictures);
    if (const auto& quilt = settings.layout.quilt()) {
      const std::filesystem::path picture = written.front();
      write_quilt_side_file(picture, *quilt);
      written.push_back(quilt_side_path(picture));
    }
    if (const std::optional<LensGrid> grid = lens_grid_of(settings.optics))
      written.push_back(write_lens_grid(written.front(), *grid));
    return written;
  }

  /// Copies the depth range, which all frames share, to the side files of the videos. Returns whether the frame has a
  /// side file.
  bool describe_depth() const {
    const auto frame = picture_paths(files.folder, files.names, first_frame).front();
    const std::optional<RgbdSideFile> side = read_rgbd_side_file(frame);
    if (side)
      for (const VideoFile& video : settings.videos) write_rgbd_side_file(video.path, *side);
    return side.has_value();
  }

  /// Returns the 8-bit samples for videos, if the pictures store linear light.
  Image8 toned_codes(const Tone& tone, Image film) const {
    apply_tone(tone, film);
    return to_codes(film, settings.encoding);
  }

  void record(const FrameReport& report, const FileRecords& records) {
    if (report.precompensation) precompensated[report.frame] = *report.precompensation;
    folder.add(report, records);
    if (!settings.written) return;
    std::uintmax_t bytes = 0;
    for (const auto& [name, sum] : records) bytes += sum.bytes;
    settings.written(report.frame, bytes);
  }

  void add_to_videos(const Image8& codes) {
    const TimedWork timed(write_nanoseconds);
    for (const auto& video : videos) video->add_frame(codes);
  }
};

FrameSink::FrameSink(const Settings& settings, RenderFolder& folder) : impl_(std::make_unique<Impl>(settings, folder)) {}
FrameSink::~FrameSink() = default;

void FrameSink::add(RenderedFrame rendered) {
  const auto shared = std::make_shared<RenderedFrame>(std::move(rendered));
  const auto files = std::make_shared<FileRecords>();
  if (impl_->first_frame < 0) impl_->first_frame = shared->report.frame;
  impl_->queue.submit([impl = impl_.get(), shared, files] { *files = impl->write(*shared); },
                      [impl = impl_.get(), shared, files] {
                        impl->record(shared->report, *files);
                        impl->add_to_videos(shared->pictures.codes);
                      });
}

void FrameSink::add_kept(int frame) {
  if (impl_->videos.empty()) return;
  if (impl_->first_frame < 0) impl_->first_frame = frame;
  const auto codes = std::make_shared<Image8>();
  const auto path = picture_paths(impl_->files.folder, impl_->files.names, frame).front();
  impl_->queue.submit([codes, path] { *codes = read_image8(path); },
                      [impl = impl_.get(), codes] { impl->add_to_videos(*codes); });
}

void FrameSink::wait() { impl_->queue.finish(); }

bool FrameSink::finish_videos() {
  const TimedWork timed(impl_->write_nanoseconds);
  for (const auto& video : impl_->videos) video->finish();
  return impl_->settings.layout.is_rgbd() && impl_->first_frame >= 0 && impl_->describe_depth();
}

const std::map<int, Precompensation>& FrameSink::precompensated() const { return impl_->precompensated; }

double FrameSink::write_seconds() const { return 1e-9 * static_cast<double>(impl_->write_nanoseconds); }

int FrameSink::frames_in_memory(int threads) { return queue_capacity(threads) + 1; }

}  // namespace lippmann
