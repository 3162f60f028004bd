// Encodes 8-bit sRGB by a table instead of pow(). The codes are exactly those of pow().
// 1. The exact formula gives the 255 floats at which the code increases (steps).
// 2. A float's exponent and top 7 mantissa bits select a bucket of 65536 floats, which contains at most one step.
// 3. The table entry of a bucket is 65536 * (code at the start of the bucket). If the bucket contains a step, the entry is
//    increased by 65536 - (position of the step in the bucket).
// 4. The code is (entry + lower 16 bits of the float) / 65536, rounded down. The sum carries into the code exactly if the float
//    is at or beyond the step.
#include "lippmann/image/encode.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

namespace lippmann {
namespace {

int srgb_code(float value, int max_code) {
  if (!(value > 0.0f)) return 0;
  return static_cast<int>(std::floor(max_code * srgb_from_linear(std::min(value, 1.0f)) + 0.5));
}

/// Returns the smallest float whose 8-bit code is `code`, from 1 to 255.
float first_value_of(int code) {
  float value = static_cast<float>(linear_from_srgb((code - 0.5) / 255.0));
  while (srgb_code(value, 255) >= code) value = std::nextafter(value, 0.0f);
  while (srgb_code(value, 255) < code) value = std::nextafter(value, 1.0f);
  return value;
}

class SrgbTable {
 public:
  SrgbTable() {
    std::array<std::uint32_t, 256> steps{};
    for (int code = 1; code < 256; ++code) steps[code] = std::bit_cast<std::uint32_t>(first_value_of(code));
    std::uint32_t code = 0;
    for (std::uint32_t bucket = 0; bucket < kBuckets; ++bucket) {
      const std::uint32_t begin = kFirstBits + (bucket << kBucketBits), end = begin + (1u << kBucketBits);
      if (code < 255 && steps[code + 1] == begin) ++code;
      entries_[bucket] = code << kBucketBits;
      if (code == 255 || steps[code + 1] >= end) continue;
      entries_[bucket] += end - steps[code + 1];
      ++code;
      assert(code == 255 || steps[code + 1] >= end);
    }
    assert(code == 255);
  }

  unsigned char operator()(float value) const {
    value = value > kFirst ? value : kFirst;  // also replaces NaN: comparisons with NaN are false
    value = value < kLast ? value : kLast;
    const std::uint32_t offset = std::bit_cast<std::uint32_t>(value) - kFirstBits;
    return static_cast<unsigned char>((entries_[offset >> kBucketBits] + (offset & ((1u << kBucketBits) - 1))) >> kBucketBits);
  }

 private:
  static constexpr int kBucketBits = 16;
  static constexpr float kFirst = 0x1p-13f;  // start of the table, 1.22e-4; its code is 0, because code 1 begins at 1.52e-4
  static constexpr float kLast = 1.0f - 0x1p-24f;  // end of the table: the largest float below 1; its code is 255
  static constexpr std::uint32_t kFirstBits = std::bit_cast<std::uint32_t>(kFirst);
  static constexpr std::uint32_t kBuckets = (std::bit_cast<std::uint32_t>(1.0f) - kFirstBits) >> kBucketBits;
  std::array<std::uint32_t, kBuckets> entries_{};
};

int truncated_code(float value, int max_code) {
  const float scaled = value * static_cast<float>(max_code);
  if (!(scaled > 0.0f)) return 0;
  return scaled < static_cast<float>(max_code) ? static_cast<int>(scaled) : max_code;
}

template <class Code, class F>
std::vector<Code> encode(const Image& film, const F& code) {
  assert(film.channels > 0);
  const std::size_t pixels = static_cast<std::size_t>(film.width) * film.height;
  std::vector<Code> rgb(3 * pixels);
  if (film.channels == 3) {
    std::transform(film.data.begin(), film.data.end(), rgb.begin(), code);
    return rgb;
  }
  const int step = film.channels > 3 ? 1 : 0;
  for (std::size_t i = 0; i < pixels; ++i)
    for (int c = 0; c < 3; ++c) rgb[3 * i + c] = code(film.data[i * film.channels + c * step]);
  return rgb;
}

void count_nans(const Image& film, std::size_t* nan_count) {
  if (nan_count) *nan_count = std::count_if(film.data.begin(), film.data.end(), [](float v) { return std::isnan(v); });
}

template <class Code>
std::vector<Code> linear_codes(const Image& alpha, float max_code) {
  std::vector<Code> codes(alpha.data.size());
  std::transform(alpha.data.begin(), alpha.data.end(), codes.begin(),
                 [=](float a) { return static_cast<Code>(max_code * std::clamp(a, 0.0f, 1.0f) + 0.5f); });
  return codes;
}

}  // namespace

std::vector<unsigned char> alpha_codes(const Image& alpha) { return linear_codes<unsigned char>(alpha, 255.0f); }
std::vector<std::uint16_t> alpha_codes16(const Image& alpha) { return linear_codes<std::uint16_t>(alpha, 65535.0f); }

void divide_by_alpha(const Image& alpha, Image& film) {
  assert(film.data.size() == 3 * alpha.data.size());
  for (std::size_t i = 0; i < film.data.size(); ++i)
    film.data[i] = alpha.data[i / 3] > 0.0f ? film.data[i] / alpha.data[i / 3] : 0.0f;
}

double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double linear_from_srgb(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

Image8 to_codes(const Image& film, Encoding encoding, std::size_t* nan_count) {
  static const SrgbTable kSrgbCode;
  count_nans(film, nan_count);
  if (encoding == Encoding::kSrgb) return {film.width, film.height, encode<unsigned char>(film, kSrgbCode)};
  return {film.width, film.height, encode<unsigned char>(film, [](float v) { return truncated_code(v, 255); })};
}

Image16 to_codes16(const Image& film, Encoding encoding, std::size_t* nan_count) {
  count_nans(film, nan_count);
  if (encoding == Encoding::kSrgb)
    return {film.width, film.height, encode<std::uint16_t>(film, [](float v) { return srgb_code(v, 65535); })};
  return {film.width, film.height, encode<std::uint16_t>(film, [](float v) { return truncated_code(v, 65535); })};
}

}  // namespace lippmann
