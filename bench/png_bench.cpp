#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/benchmarks.hpp"
#include "bench/timing.hpp"
#include "core/platform.hpp"
#include "core/random.hpp"
#include "image/png.hpp"
#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann::bench {
namespace {

constexpr int kPngSize = 512, kLensPixels = 8;

struct Ball {
  Vec3f center;
  float radius;
  Vec3f color;
};

const Ball kBalls[] = {{{180, 300, 1.5f}, 110, {0.8f, 0.3f, 0.2f}},
                       {{350, 230, -0.8f}, 70, {0.2f, 0.5f, 0.8f}},
                       {{410, 380, 3.0f}, 60, {0.7f, 0.7f, 0.2f}},
                       {{90, 150, -2.0f}, 40, {0.3f, 0.7f, 0.3f}}};

Vec3f shade(float x, float y, float view) {
  const Vec3f light = glm::normalize(Vec3f(-0.4f, -0.7f, 0.6f)), half = glm::normalize(light + Vec3f(0, 0, 1));
  Vec3f color(0.2f + 0.001f * y, 0.3f + 0.0008f * y, 0.7f - 0.0005f * y);
  if (y > 256) {
    const float depth = 3000.0f / (y - 250.0f);
    const int tile = static_cast<int>(std::floor((x - 256 + view * (2 - depth)) * depth * 0.0015f) + std::floor(depth * 0.12f));
    color = Vec3f(tile & 1 ? 0.7f : 0.15f) / (1.0f + 0.01f * depth);
  }
  float nearest = -kInfinity;
  for (const Ball& ball : kBalls) {
    const float dx = (x - ball.center.x - ball.center.z * view) / ball.radius, dy = (y - ball.center.y) / ball.radius;
    const float square = 1.0f - dx * dx - dy * dy;
    if (square <= 0 || ball.center.z <= nearest) continue;
    nearest = ball.center.z;
    const Vec3f normal(dx, dy, std::sqrt(square));
    color = ball.color * (0.1f + 0.9f * std::max(0.0f, glm::dot(normal, light))) +
            0.5f * std::pow(std::max(0.0f, glm::dot(normal, half)), 40.0f);
  }
  return color;
}

enum class Kind { kView, kIntegral, kNoisyIntegral };

Image8 make_picture(Kind kind) {
  Image film(kPngSize, kPngSize, 3);
  for (int y = 0; y < kPngSize; ++y)
    for (int x = 0; x < kPngSize; ++x) {
      const int lens = x / kLensPixels;
      const Vec3f color = kind == Kind::kView ? shade(x + 0.5f, y + 0.5f, 0.0f)
                                              : shade((lens + 0.5f) * kLensPixels, y + 0.5f, x % kLensPixels - 3.5f);
      const float noise = kind == Kind::kNoisyIntegral ? 0.9f + 0.2f * unit_float(hash(x, y)) : 1.0f;
      for (int c = 0; c < 3; ++c) film.pixel(x, y)[c] = color[c] * noise;
    }
  return to_codes(film, Encoding::kSrgb);
}

bool comes_back(const Image8& image, const PngOptions& options) {
  const auto path = std::filesystem::temp_directory_path() / fmt::format("lippmann-png-bench-{}.png", platform::process_id());
  write_png(path, image, options);
  const bool equal = read_image8(path).rgb == image.rgb;
  std::filesystem::remove(path);
  return equal;
}

struct Setting {
  std::string strategy, filter;
  PngOptions options;
};

std::vector<Setting> settings() {
  const std::pair<const char*, PngFilter> filters[] = {{"none", PngFilter::kNone},   {"left", PngFilter::kLeft},
                                                       {"up", PngFilter::kUp},       {"average", PngFilter::kAverage},
                                                       {"paeth", PngFilter::kPaeth}, {"adaptive", PngFilter::kAdaptive}};
  std::vector<Setting> all;
  for (const auto& [name, filter] : filters) {
    all.push_back({"huffman", name, {1, PngStrategy::kHuffman, filter}});
    all.push_back({"run-length", name, {1, PngStrategy::kRunLength, filter}});
    for (const int level : {1, 3, 6, 9}) {
      all.push_back({"filtered", name, {level, PngStrategy::kFiltered, filter}});
      all.push_back({"default", name, {level, PngStrategy::kDefault, filter}});
    }
  }
  return all;
}

nlohmann::ordered_json measure(const std::string& picture, const Image8& image, const Setting& setting) {
  constexpr int kRuns = 7;
  std::vector<double> times;
  std::size_t bytes = 0;
  for (int run = 0; run < kRuns; ++run) {
    times.push_back(1e3 * seconds([&] { bytes = encode_png(image, setting.options).size(); }));
  }
  std::sort(times.begin(), times.end());
  return {{"picture", picture},         {"strategy", setting.strategy},
          {"filter", setting.filter},   {"level", setting.options.level},
          {"cpu_ms", times[kRuns / 2]}, {"cpu_ms_min", times.front()},
          {"cpu_ms_max", times.back()}, {"kilobytes", static_cast<double>(bytes) / 1000.0}};
}

}  // namespace

Report measure_png(const Request& request, const Context& context) {
  Report report;
  const std::pair<const char*, Kind> pictures[] = {
      {"view", Kind::kView}, {"integral", Kind::kIntegral}, {"noisy", Kind::kNoisyIntegral}};
  for (const auto& [name, kind] : pictures) {
    begin_step(request, context, fmt::format("png: {}", name));
    const Image8 image = make_picture(kind);
    for (const Setting& setting : settings()) {
      if (context.cancelled) throw interrupted();
      if (!comes_back(image, setting.options)) throw Error("png", "a decoded PNG differs from its picture");
      ++report.passed_checks;
      report.rows.push_back(measure(name, image, setting));
    }
  }
  return report;
}

}  // namespace lippmann::bench
