#include "image/netpbm.hpp"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/atomic_file.hpp"
#include "core/recorded_file.hpp"
#include "image/limits.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

static_assert(std::endian::native == std::endian::little, "codes and floats are put together from bytes in this order");

class Header {
 public:
  Header(std::span<const std::byte> file, const std::string& where)
      : text_(reinterpret_cast<const char*>(file.data()), file.size()), where_(where) {}

  std::string_view word() {
    skip_space_and_comments();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_]) && at_ - begin < kLongestWord) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  template <class Number>
  Number number(const char* what) {
    const std::string_view digits = word();
    Number value{};
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size() || digits.empty())
      throw Error(where_, fmt::format("its header has no {}", what));
    return value;
  }

  /// Returns the offset of the samples. Exactly one space or line end precedes them.
  std::size_t samples_begin() {
    if (at_ >= text_.size() || !is_space(text_[at_])) throw Error(where_, "is truncated");
    return at_ + 1;
  }

 private:
  static constexpr std::size_t kLongestWord = 64;
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }

  void skip_space_and_comments() {
    bool comment = false;
    for (; at_ < text_.size(); ++at_) {
      comment = comment ? text_[at_] != '\n' : text_[at_] == '#';
      if (!comment && !is_space(text_[at_])) return;
    }
  }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 0;
};

std::span<const std::byte> samples(std::span<const std::byte> file, Header& header, const std::string& where, int width,
                                   int height, std::size_t bytes_per_pixel) {
  check_image_size(where, width, height, 3);
  const std::size_t begin = header.samples_begin();
  const std::size_t needed = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * bytes_per_pixel;
  if (file.size() - begin < needed)
    throw Error(where, fmt::format("is truncated: {} of {} bytes of samples", file.size() - begin, needed));
  return file.subspan(begin, needed);
}

void append(std::vector<std::byte>& bytes, const std::string& text) {
  for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
}

}  // namespace

PpmCodes parse_ppm(std::span<const std::byte> file, const std::string& where) {
  Header header(file, where);
  const std::string_view magic = header.word();
  if (magic != "P6" && magic != "P5") throw Error(where, "is not a PPM picture", "a file that begins with P6 or P5");
  PpmCodes picture;
  const int width = header.number<int>("width"), height = header.number<int>("height");
  picture.highest = header.number<int>("highest code");
  if (picture.highest < 1 || picture.highest > 65535)
    throw Error(where, fmt::format("its highest code is {}", picture.highest), "1 to 65535");
  const std::size_t channels = magic == "P6" ? 3 : 1, bytes_per_code = picture.highest > 255 ? 2 : 1;
  const auto from = samples(file, header, where, width, height, channels * bytes_per_code);
  picture.codes = {width, height, {}};
  picture.codes.rgb.reserve(from.size() / bytes_per_code * (3 / channels));
  for (std::size_t i = 0; i < from.size(); i += bytes_per_code) {
    const auto first = std::to_integer<unsigned>(from[i]);
    const unsigned code = bytes_per_code == 2 ? first << 8 | std::to_integer<unsigned>(from[i + 1]) : first;
    if (code > static_cast<unsigned>(picture.highest))
      throw Error(where, fmt::format("has a sample of {}, above the maximum of {} in its header", code, picture.highest));
    picture.codes.rgb.insert(picture.codes.rgb.end(), 3 / channels, static_cast<std::uint16_t>(code));
  }
  return picture;
}

Image parse_pfm(std::span<const std::byte> file, const std::string& where) {
  Header header(file, where);
  const std::string_view magic = header.word();
  if (magic != "Pf" && magic != "PF") throw Error(where, "is not a PFM picture", "a file that begins with Pf or PF");
  const int channels = magic == "PF" ? 3 : 1;
  const int width = header.number<int>("width"), height = header.number<int>("height");
  const auto scale = header.number<float>("scale");
  if (!std::isfinite(scale) || scale == 0.0f)
    throw Error(where, fmt::format("its scale is {}", scale), "a number other than 0");
  const std::size_t row = static_cast<std::size_t>(channels) * static_cast<std::size_t>(std::max(width, 0));
  const auto from = samples(file, header, where, width, height, 4 * static_cast<std::size_t>(channels));
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (std::size_t i = 0; i < row; ++i) {
      std::uint32_t bits;
      std::memcpy(&bits, &from[4 * (static_cast<std::size_t>(height - 1 - y) * row + i)], 4);
      if (scale > 0.0f) bits = __builtin_bswap32(bits);
      image.data[static_cast<std::size_t>(y) * row + i] = std::bit_cast<float>(bits) * std::abs(scale);
    }
  return image;
}

PpmCodes read_ppm(const std::filesystem::path& path) {
  return parse_ppm(read_recorded_bytes(path, kMaxImageFileBytes, "a picture"), path.string());
}
Image read_pfm(const std::filesystem::path& path) {
  return parse_pfm(read_recorded_bytes(path, kMaxImageFileBytes, "a picture"), path.string());
}

std::vector<std::byte> encode_ppm(const PpmCodes& picture) {
  std::vector<std::byte> bytes;
  bytes.reserve(picture.codes.rgb.size() * 2 + 32);
  append(bytes, fmt::format("P6\n{} {}\n{}\n", picture.codes.width, picture.codes.height, picture.highest));
  for (const std::uint16_t code : picture.codes.rgb) {
    if (picture.highest > 255) bytes.push_back(static_cast<std::byte>(code >> 8));
    bytes.push_back(static_cast<std::byte>(code & 255));
  }
  return bytes;
}

std::vector<std::byte> encode_pfm(const Image& image) {
  assert(image.channels == 1 || image.channels == 3);
  std::vector<std::byte> bytes;
  bytes.reserve(image.data.size() * 4 + 32);
  append(bytes, fmt::format("{}\n{} {}\n-1\n", image.channels == 3 ? "PF" : "Pf", image.width, image.height));
  for (int y = image.height; y-- > 0;) {
    const auto row = std::as_bytes(std::span(image.pixel(0, y), static_cast<std::size_t>(image.width * image.channels)));
    bytes.insert(bytes.end(), row.begin(), row.end());
  }
  return bytes;
}

void write_ppm(const std::filesystem::path& path, const PpmCodes& picture) { write_file_atomically(path, encode_ppm(picture)); }
void write_pfm(const std::filesystem::path& path, const Image& image) { write_file_atomically(path, encode_pfm(image)); }

}  // namespace lippmann
