#include "frames/traced_frames.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "denoise/denoiser.hpp"
#include "frames/audit.hpp"
#include "trace/noisy_frame.hpp"
#include "trace/strip_order.hpp"

namespace lippmann {

int rows_around(const Sampling& sampling, const Optics& optics) {
  return is_denoised(sampling) ? Denoiser::rows_around(optics) : 0;
}

namespace {

/// Extends `rows` on both sides by `around`, rounded outwards to bands that are traced together.
FilmRows with_rows_around(FilmRows rows, int around, const Optics& optics) {
  const int height = film_size(optics).y, together = rows_per_strip(optics), end = std::min(rows.end, height) + around;
  return {std::max(rows.first - around, 0) / together * together, std::min((end + together - 1) / together * together, height)};
}

class TracedFrames final : public FrameMaker {
 public:
  explicit TracedFrames(const MakerParts& parts);

  RenderedFrame make(int frame) override;

 private:
  RenderedFrame denoised(int frame);
  void keep_rows(FilmRows rows, FramePictures& pictures) const;

  MakerParts parts_;
  FilmRows traced_rows_;
  std::optional<Denoiser> denoiser_;
};

TracedFrames::TracedFrames(const MakerParts& parts)
    : parts_(parts),
      traced_rows_(with_rows_around(parts.stage.rows, rows_around(parts.sampling, parts.stage.placed.optics),
                                    parts.stage.placed.optics)) {
  if (is_denoised(parts.sampling)) denoiser_.emplace(parts.stage.placed.optics, traced_rows_.first, traced_rows_.end);
}

RenderedFrame TracedFrames::make(int frame) {
  RenderedFrame rendered =
      denoiser_ ? denoised(frame) : render_frame(parts_.stage, parts_.sampling, frame, parts_.pool, parts_.context);
  if (facts_of(parts_.sampling).is_stochastic && !parts_.context.cancelled)
    audit(parts_.stage, parts_.sampling, frame, rendered.pictures.film, parts_.pool, parts_.context, rendered.report);
  return rendered;
}

RenderedFrame TracedFrames::denoised(int frame) {
  NoisyFrame noisy;
  const FilmRows own = std::exchange(parts_.stage.rows, traced_rows_);
  RenderedFrame rendered = render_noisy_frame(parts_.stage, parts_.sampling, frame, parts_.pool, parts_.context, noisy);
  parts_.stage.rows = own;
  if (parts_.context.cancelled) return rendered;
  const FrameClock clock(parts_.pool);
  const Mat3f display_from_world = inverse(parts_.stage.moment_at(frame).world_from_display).linear;
  rendered.pictures.film = denoiser_->denoise(
      {noisy.film, noisy.noise, noisy.seen, noisy.albedo, noisy.normal, noisy.z, noisy.met, display_from_world}, parts_.pool);
  keep_rows(own, rendered.pictures);
  clock.add_to(rendered.report);
  return rendered;
}

void TracedFrames::keep_rows(FilmRows rows, FramePictures& pictures) const {
  rows.end = std::min(rows.end, film_size(parts_.stage.placed.optics).y);
  if (rows == traced_rows_) return;
  const auto keep = [&](Image& image) {
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(image.width) * image.channels;
    const auto first = image.data.begin() + (rows.first - traced_rows_.first) * row;
    image.height = rows.end - rows.first;
    image.data = std::vector<float>(first, first + image.height * row);
  };
  keep(pictures.film);
  for (std::size_t i = 0; i < kAovs; ++i)
    if (pictures.aovs.wanted[i]) keep(pictures.aovs.images[i]);
}

}  // namespace

std::unique_ptr<FrameMaker> make_traced_frames(const MakerParts& parts) { return std::make_unique<TracedFrames>(parts); }

double traced_frames_bytes_per_pixel(const Sampling& sampling) {
  return is_denoised(sampling) ? kNoisyFrameBytesPerPixel + Denoiser::kWorkBytesPerPixel : 0.0;
}

}  // namespace lippmann
