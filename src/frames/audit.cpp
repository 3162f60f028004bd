#include "frames/audit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann {
namespace {

/// One of this many pixels is traced again: twice, each time with kPathsPerSample times its paths. This adds 2 * 4 / 500 = 1.6
/// % to the frame's paths.
constexpr std::size_t kPixelsPerHeldOut = 500;
/// Lowest number of pixels that are traced again. With fewer, the confidence interval of the PSNR would be wider than 6 dB.
constexpr std::size_t kLeastHeldOut = 64;
/// Each of a pixel's two new images has this many times the paths of the frame. Together they have 8 times the paths. Their
/// error is therefore not larger than that of a denoised frame, which may be as accurate as an image with 8 times the paths.
constexpr int kPathsPerSample = 4;
/// Lowest number of paths of a retraced pixel. The sRGB code of a mean of few paths is biased, because the transfer curve is
/// not linear.
constexpr int kLeastPaths = 32;
/// Half the width of the 90 % interval, in standard errors. A normal distribution would need only 1.645, but the standard error
/// is underestimated if a few pixels cause most of the error. `lippmann-bench estimates` measures the coverage of the interval.
constexpr double kDeviations = 2.0;

constexpr std::uint32_t kPlacesSalt = 0x61756469u, kFirstSalt = 0x61756431u, kSecondSalt = 0x61756432u;

using Color = std::array<double, 3>;

std::vector<std::uint32_t> held_out_pixels(std::size_t pixels, std::uint32_t seed) {
  const std::size_t count = std::min(pixels, std::max(kLeastHeldOut, pixels / kPixelsPerHeldOut));
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i * pixels / count, end = (i + 1) * pixels / count;
    chosen.push_back(static_cast<std::uint32_t>(first + hash(seed, static_cast<std::uint32_t>(i)) %
                                                            static_cast<std::uint32_t>(end - first)));
  }
  return chosen;
}

std::vector<Color> codes_at(std::span<const std::uint32_t> pixels, const Image& film) {
  std::vector<Color> codes;
  for (const std::uint32_t pixel : pixels) {
    Color& color = codes.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const float light = film.data[3 * static_cast<std::size_t>(pixel) + c];
      color[c] = srgb_from_linear(std::clamp(static_cast<double>(std::isfinite(light) ? light : 0.0f), 0.0, 1.0));
    }
  }
  return codes;
}

/// Traces `pixels` again and returns their sRGB codes. The film has its old values on return.
std::vector<Color> traced_codes(const Shot& shot, const TraceParams& trace, std::span<const std::uint32_t> pixels,
                                const Workers& workers, Image& film, float* open, RayCounts& rays) {
  std::vector<float> own;
  const auto place = [&](std::uint32_t pixel) { return film.data.begin() + 3 * static_cast<std::ptrdiff_t>(pixel); };
  for (const std::uint32_t pixel : pixels) own.insert(own.end(), place(pixel), place(pixel) + 3);
  add(trace_pixels(shot, trace, pixels, workers, film, nullptr, open), rays);
  std::vector<Color> codes = codes_at(pixels, film);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    std::copy_n(own.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, place(pixels[i]));
  return codes;
}

double psnr_of(double squared_error) { return psnr_db(255.0 * 255.0 * squared_error); }

}  // namespace

ErrorInterval error_interval(std::span<const double> samples) {
  const auto count = static_cast<double>(samples.size());
  double sum = 0.0;
  for (const double sample : samples) sum += sample;
  const double mean = sum / count;
  double squares = 0.0;
  for (const double sample : samples) squares += (sample - mean) * (sample - mean);
  const double width = kDeviations * std::sqrt(squares / (count - 1.0) / count);
  if (!(mean > 0.0)) return {0.0, 0.0, width};
  return {mean, mean * std::exp(-width / mean), mean * std::exp(width / mean)};
}

void audit(Stage& stage, const Sampling& sampling, int frame, Image& film, const ThreadPool& pool, const Context& context,
           FrameReport& report) {
  if (sampling.shutter > 0.0f) return;
  const FrameClock clock(pool);
  const Shot shot = stage.shot(stage.moment_at(frame));
  const std::size_t size = film.data.size() / 3;
  const auto number = static_cast<std::uint32_t>(frame);
  const std::vector<std::uint32_t> pixels =
      held_out_pixels(size, hash(sampling.seed, number, kPlacesSalt + static_cast<std::uint32_t>(stage.rows.first)));
  if (pixels.size() < 2) return;
  TraceParams trace = trace_params(sampling, stage);
  trace.frame = number;
  trace.spp = std::max(kLeastPaths, kPathsPerSample * trace.spp);
  std::vector<float> open(sampling.transparent ? size : 0);
  const auto codes_by = [&](std::uint32_t salt) {
    trace.seed = hash(sampling.seed, salt);
    return traced_codes(shot, trace, pixels, Workers{pool, context}.silent(), film, open.empty() ? nullptr : open.data(),
                        report.rays);
  };
  const std::vector<Color> shown = codes_at(pixels, film), first = codes_by(kFirstSalt), second = codes_by(kSecondSalt);
  if (context.cancelled) return;
  std::vector<double> squared_errors;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c) sum += (shown[i][c] - first[i][c]) * (shown[i][c] - second[i][c]);
    squared_errors.push_back(sum / 3.0);
  }
  const ErrorInterval error = error_interval(squared_errors);
  if (error.mean > 0.0) report.estimated_psnr_db = psnr_of(error.mean), report.psnr_at_most_db = psnr_of(error.low);
  if (error.high > 0.0) report.psnr_at_least_db = psnr_of(error.high);
  clock.add_to(report);
}

}  // namespace lippmann
