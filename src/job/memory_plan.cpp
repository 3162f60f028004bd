#include "job/memory_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "folder/frame_files.hpp"
#include "frames/frame_maker.hpp"
#include "job/size_estimate.hpp"
#include "lippmann/core/error.hpp"
#include "video/video_codec.hpp"

namespace lippmann {
namespace {

constexpr double kFilm = 3 * sizeof(float);

/// An encoded file is a vector that doubles its capacity when it is full, so it takes up to twice its size.
constexpr double kGrowth = 2.0;

/// Fraction of the available memory that a plan may use. The rest allows for errors of the estimate and for other
/// programs.
constexpr double kReserve = 0.8;

std::vector<Aov> layers_of(const MemoryFacts& facts) {
  const FrameAovs wanted = wanted_aovs(facts.frame_settings.sampling);
  std::vector<Aov> layers;
  for (std::size_t i = 0; i < kAovs; ++i)
    if (wanted.wanted[i]) layers.push_back(static_cast<Aov>(i));
  return layers;
}

double bytes_of(Aov aov) { return sizeof(float) * channels_of(aov); }

/// Bytes per pixel of a frame's film and layers.
double frame_held(const MemoryFacts& facts) {
  double bytes = kFilm;
  for (const Aov aov : layers_of(facts)) bytes += bytes_of(aov);
  return bytes;
}

/// Bytes per pixel for encoding a picture: its integer or half-float samples, and the encoded file, which is assumed to be as
/// large as the file of a noisy picture.
double picture_written(const MemoryFacts& facts) {
  constexpr double kPngFile = 3 * 0.6, kPng16File = 3 * 1.7, kHalfFile = 3 * 1.3, kFloatFile = 3 * 2.9;
  constexpr double kCodes = 3.0, kCodes16 = 6.0, kHalves = 6.0;
  const double video_codes = facts.params.output.video.empty() ? 0.0 : kCodes;
  switch (facts.layout.format()) {
    case PictureFormat::kPng:
      return kCodes + kGrowth * kPngFile;
    case PictureFormat::kPng16:
      return kCodes16 + kGrowth * kPng16File + video_codes;
    case PictureFormat::kTiff:
      return kCodes;
    case PictureFormat::kExr:
      break;
  }
  const bool floats = facts.params.output.pictures.exr_pixels == ExrPixels::kFloat;
  return (floats ? kGrowth * kFloatFile : kHalves + kGrowth * kHalfFile) + video_codes;
}

/// Bytes per pixel for encoding layers. Layers that are stored as 16-bit floats are converted first. In formats other
/// than EXR, alpha is encoded as part of the picture.
double layers_written(const MemoryFacts& facts) {
  double bytes = 0.0;
  for (const Aov aov : layers_of(facts)) {
    const AovInfo& info = info_of(aov);
    if (aov == Aov::kAlpha && facts.layout.format() != PictureFormat::kExr)
      bytes += 5.0;
    else
      bytes += (info.exr.is_float ? 0.0 : 2.0 * info.channels) + kGrowth * info.exr.bytes_per_pixel;
  }
  return bytes;
}

/// Bytes per pixel for rearranging a frame in another layout: a second film, and a second copy of one layer at a time.
double moved_bytes(const MemoryFacts& facts) {
  if (!facts.layout.moves()) return 0.0;
  double layer = 0.0;
  for (const Aov aov : layers_of(facts)) layer = std::max(layer, bytes_of(aov));
  return kFilm + layer;
}

/// Bytes per pixel of a light field that is assembled from film and depth before it is written.
double light_field_bytes(const MemoryFacts& facts) {
  if (!facts.layout.light_field()) return 0.0;
  return kFilm + 2.0 * sizeof(float);
}

/// Bytes per pixel that a video encoder buffers.
double video_bytes(VideoCodec codec) {
  switch (codec) {
    case VideoCodec::kH264:
      return 60.0;
    case VideoCodec::kHevc:
      return 125.0;
    case VideoCodec::kVp9:
      return 140.0;
    case VideoCodec::kAv1:
      return 270.0;
    case VideoCodec::kFfv1:
      return 170.0;
  }
  return 0.0;
}

double videos_written(const MemoryFacts& facts) {
  if (!facts.writes_videos) return 0.0;
  const Vec2i size = facts.layout.picture_size();
  double bytes = 0.0;
  for (const std::string& video : facts.params.output.video)
    bytes += video_bytes(choose_codec(video, facts.params.output.video_codec, size.x, size.y));
  return bytes;
}

/// Bytes per pixel for writing a frame, in addition to its film and layers.
double writing(const MemoryFacts& facts) {
  const double precompensated = facts.params.optics.precompensate ? 2.0 * kFilm : 0.0;
  return picture_written(facts) + layers_written(facts) + moved_bytes(facts) + light_field_bytes(facts) + precompensated +
         videos_written(facts);
}

/// Bytes per pixel of the table from pixels of the layout to pixels of the film. All frames share one table.
double layout_tables(const MemoryFacts& facts) { return facts.layout.moves() ? sizeof(std::uint32_t) : 0.0; }

double working(const MemoryFacts& facts) { return working_bytes_per_pixel(facts.frame_settings, facts.frames); }

double pixels_of(const MemoryFacts& facts) { return static_cast<double>(facts.film.x) * facts.film.y; }

/// Returns why frames cannot be traced in bands, or an empty string.
std::string reason_against_bands(const MemoryFacts& facts) {
  const FrameParams& frame_settings = facts.frame_settings;
  if (facts.rows_around >= facts.film.y) return "the denoiser (`denoise`) averages views of all rows of the quilt";
  if (std::holds_alternative<Interpolate>(frame_settings.reuse))
    return "interpolated frames (`reuse`) are made from whole ones";
  if (facts.most_bands == 1) return "the rows of this picture are traced together";
  return {};
}

/// Fraction of a frame's rows that is traced at once.
double traced_share(const MemoryFacts& facts, int bands) {
  return bands > 1 ? std::min(1.0, 1.0 / bands + 2.0 * facts.rows_around / facts.film.y) : 1.0;
}

[[noreturn]] void refuse(const MemoryFacts& facts, double needed, double available) {
  const std::string reason = reason_against_bands(facts);
  const std::string bands = reason.empty() ? ", even in bands of rows" : "";
  throw Error("size",
              fmt::format("frames of {}x{} pixels need about {} of memory{}, but {} are available{}", facts.film.x,
                          facts.film.y, bytes_text(needed), bands, bytes_text(available),
                          reason.empty() ? "" : "; bands of rows, which need less, are not possible: " + reason),
              "fewer pixels, fewer layers, or more memory");
}

}  // namespace

double estimated_bytes(const MemoryFacts& facts, int frames_at_a_time, int bands) {
  const double held = frame_held(facts), traced = traced_share(facts, bands), traced_apart = bands > 1 ? held * traced : 0.0;
  const double per_pixel =
      layout_tables(facts) + frames_at_a_time * held + traced_apart + working(facts) * traced + writing(facts);
  return pixels_of(facts) * per_pixel;
}

double joined_frame_bytes(const MemoryFacts& facts) {
  return pixels_of(facts) * (layout_tables(facts) + frame_held(facts) + writing(facts));
}

MemoryPlan plan_strips_memory(const MemoryFacts& facts, int strips, bool joins, double available) {
  constexpr double kCopies = 2.0;  // the strip itself, and its file, which is encoded in memory
  const double strip = pixels_of(facts) * traced_share(facts, strips) * (kCopies * frame_held(facts) + working(facts));
  if (strip > available)
    throw Error("strips",
                fmt::format("{} of {}x{} pixels need about {} of memory each, but {} are available", strips, facts.film.x,
                            facts.film.y, bytes_text(strip), bytes_text(available)),
                "more `strips`");
  const double joined = joins ? joined_frame_bytes(facts) : 0.0;
  if (joined > available)
    throw Error("size",
                fmt::format("joining a frame of {}x{} pixels from its strips needs about {} of memory, but {} are available",
                            facts.film.x, facts.film.y, bytes_text(joined), bytes_text(available)),
                "fewer pixels, fewer layers, or more memory");
  // The heap keeps most of the memory that tracing used, so the memory for joining is added.
  return {1, false, strip + joined};
}

MemoryPlan plan_memory(const MemoryFacts& facts, double available) {
  const double budget = kReserve * available;
  const int usual = std::min(facts.frames_at_a_time, facts.frames);
  if (estimated_bytes(facts, usual, 1) <= budget) return {1, false, estimated_bytes(facts, std::min(usual, 2), 1)};
  const double one = estimated_bytes(facts, 1, 1);
  if (one <= budget) return {1, true, one};
  if (!reason_against_bands(facts).empty()) {
    if (one > available) refuse(facts, one, available);
    return {1, true, one};
  }
  for (const double limit : {budget, available})
    for (int bands = 2; bands <= facts.most_bands; bands = std::max(bands + 1, bands * 5 / 4))
      if (const double bytes = estimated_bytes(facts, 1, bands); bytes <= limit) return {bands, true, bytes};
  refuse(facts, std::min(one, estimated_bytes(facts, 1, facts.most_bands)), available);
}

std::string sentence_of(const MemoryPlan& plan, const MemoryFacts& facts, double available) {
  if (plan.bands == 1 && (!plan.one_at_a_time || facts.frames == 1)) return {};
  const std::string why = fmt::format(
      "Whole frames of {}x{} pixels would take about {} of memory, but {} are available: ", facts.film.x, facts.film.y,
      bytes_text(estimated_bytes(facts, plan.bands > 1 ? 1 : facts.frames_at_a_time, 1)), bytes_text(available));
  if (plan.bands == 1) return why + "each frame is written before the next one is rendered.";
  return why + fmt::format("each is rendered in {} bands of rows, to the same pixels.", plan.bands);
}

}  // namespace lippmann
