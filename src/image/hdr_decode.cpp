// Radiance HDR: three mantissas and an exponent that they share.
//
// Based on: Greg Ward, "Real Pixels", Graphics Gems II, 1991, and the format's description in Radiance's manual: a header of
// text lines, an empty line, "-Y height +X width", then rows from the top. A row is stored as it is, or by runs: it begins
// with 2, 2 and the width in two bytes, and its four components follow one after the other, each as runs (a count above 128,
// then one byte) and dumps (a count, then so many bytes).
//   value = mantissa 2^(exponent - 136); 0 where the exponent is 0.
// We deviate: 1. Other orientations than -Y +X are refused. 2. EXPOSURE and the primaries are ignored, as other readers do.
// 3. XYZE is refused. 4. The runs of the oldest files (1, 1, 1, count) are read too.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "image/decode.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

struct Start {
  PictureHeader header;
  std::size_t samples = 0;  // where they begin
};

std::string_view text_of(FileBytes file) { return {reinterpret_cast<const char*>(file.data()), file.size()}; }

/// "-Y 480 +X 640".
bool parse_resolution(std::string_view line, int& width, int& height) {
  const auto number = [&line](std::string_view name, int& value) {
    if (!line.starts_with(name)) return false;
    line.remove_prefix(name.size());
    const auto read = std::from_chars(line.data(), line.data() + line.size(), value);
    line.remove_prefix(static_cast<std::size_t>(read.ptr - line.data()));
    return read.ec == std::errc();
  };
  return number("-Y ", height) && number(" +X ", width) && (line.empty() || line == "\r");
}

Start parse_start(FileBytes file, const std::string& where) {
  constexpr std::size_t kLongestHeader = 1 << 20;
  const std::string_view text = text_of(file).substr(0, kLongestHeader);
  std::size_t at = 0;
  const auto line = [&] {
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) throw unreadable_picture(where, "the file is truncated in its header");
    const std::string_view found = text.substr(at, end - at);
    at = end + 1;
    return found;
  };
  for (std::string_view said = line(); !said.empty() && said != "\r"; said = line())
    if (said.starts_with("FORMAT=") && said.find("32-bit_rle_rgbe") == std::string_view::npos)
      throw Error(where, "cannot be read as a picture: its colours are not RGB", "FORMAT=32-bit_rle_rgbe");
  int width = 0, height = 0;
  if (!parse_resolution(line(), width, height))
    throw Error(where, "cannot be read as a picture: its orientation is not known", "-Y HEIGHT +X WIDTH");
  check_image_size(where, width, height, 3);
  // A run of 127 takes two bytes; of the oldest kind four bytes repeat a pixel up to 2^24 times, which nobody makes use of.
  constexpr std::uint64_t kRatio = 64;
  check_file_holds(where, file.size() - at, 4 * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height), kRatio);
  return {{width, height, default_channels(3), SampleKind::kFloat}, at};
}

class Rows {
 public:
  Rows(FileBytes rest, const std::string& where) : rest_(rest), where_(where) {}

  /// Four bytes per pixel, in `row`.
  void read(std::vector<std::uint8_t>& row) {
    const std::size_t width = row.size() / 4;
    std::uint8_t first[4];
    for (std::uint8_t& byte : first) byte = next();
    if (first[0] == 2 && first[1] == 2 && first[2] < 128 && width >= 8 && width < 32768)
      read_components(row, static_cast<std::size_t>(first[2]) << 8 | first[3]);
    else
      read_pixels(row, first);
  }

 private:
  std::uint8_t next() {
    if (rest_.empty()) throw unreadable_picture(where_, "the file is truncated");
    const auto byte = std::to_integer<std::uint8_t>(rest_.front());
    rest_ = rest_.subspan(1);
    return byte;
  }

  void read_components(std::vector<std::uint8_t>& row, std::size_t said) {
    const std::size_t width = row.size() / 4;
    if (said != width) throw unreadable_picture(where_, "a row of it is damaged");
    for (std::size_t component = 0; component < 4; ++component)
      for (std::size_t x = 0; x < width;) {
        const std::uint8_t code = next();
        const bool run = code > 128;
        const std::size_t count = run ? code - 128u : code;
        if (count == 0 || count > width - x) throw unreadable_picture(where_, "a row of it is damaged");
        const std::uint8_t repeated = run ? next() : std::uint8_t{0};
        for (std::size_t i = 0; i < count; ++i, ++x) row[4 * x + component] = run ? repeated : next();
      }
  }

  void read_pixels(std::vector<std::uint8_t>& row, const std::uint8_t (&first)[4]) {
    const std::size_t width = row.size() / 4;
    std::uint8_t pixel[4];
    std::memcpy(pixel, first, 4);
    unsigned shift = 0;  // of the next count of repeats
    for (std::size_t x = 0; x < width;) {
      if (x > 0 || shift > 0)
        for (std::uint8_t& byte : pixel) byte = next();
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1 && x > 0) {
        if (shift > 16) throw unreadable_picture(where_, "a row of it is damaged");
        const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
        if (count > width - x) throw unreadable_picture(where_, "a row of it is damaged");
        for (std::size_t i = 0; i < count; ++i, ++x) std::memcpy(&row[4 * x], &row[4 * (x - 1)], 4);
        shift += 8;
      } else {
        std::memcpy(&row[4 * x++], pixel, 4);
        shift = 0;
      }
    }
  }

  FileBytes rest_;
  const std::string& where_;
};

}  // namespace

bool is_hdr(FileBytes file) { return text_of(file).starts_with("#?RADIANCE") || text_of(file).starts_with("#?RGBE"); }

PictureHeader hdr_header(FileBytes file, const std::string& where) { return parse_start(file, where).header; }

DecodedPicture decode_hdr(FileBytes file, const std::string& where) {
  Start start = parse_start(file, where);
  const auto width = static_cast<std::size_t>(start.header.width), height = static_cast<std::size_t>(start.header.height);
  std::vector<float> values(3 * width * height);
  std::vector<std::uint8_t> row(4 * width);
  Rows rows(file.subspan(start.samples), where);
  for (std::size_t y = 0; y < height; ++y) {
    rows.read(row);
    for (std::size_t x = 0; x < width; ++x) {
      const float scale = row[4 * x + 3] == 0 ? 0.0f : std::ldexp(1.0f, row[4 * x + 3] - 136);
      for (std::size_t c = 0; c < 3; ++c) values[3 * (y * width + x) + c] = scale * static_cast<float>(row[4 * x + c]);
    }
  }
  return {std::move(start.header), std::move(values)};
}

}  // namespace lippmann
