// Decodes Radiance HDR. Based on: Greg Ward, "Real Pixels", Graphics Gems II, 1991, and the Radiance file formats document.
//
// A file has header lines, an empty line, a line with the order and number of rows and columns, and scan lines. A pixel has
// four bytes: three mantissas and their common exponent. A scan line is stored in one of three ways:
// 1. pixel by pixel, uncompressed;
// 2. pixel by pixel with runs: the pixel 1, 1, 1, n means n repetitions of the previous pixel;
// 3. by component: the bytes 2, 2 and the length of the line (2 bytes), then all values of each of the four components,
//    compressed by runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "core/printable.hpp"
#include "image/chromaticities.hpp"
#include "image/decode.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

struct HdrShape {
  int width = 0, height = 0;
  bool rows_first = true;          ///< scan lines are rows, not columns
  bool down = true, right = true;  ///< rows run from top to bottom, and columns from left to right

  int lines() const { return rows_first ? height : width; }
  int line_pixels() const { return rows_first ? width : height; }
  std::size_t pixel(int line, int place) const {
    const int y = rows_first ? line : place, x = rows_first ? place : line;
    return static_cast<std::size_t>(down ? y : height - 1 - y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(right ? x : width - 1 - x);
  }
};

struct HdrHeader {
  HdrShape shape;
  std::array<double, 3> exposure{1.0, 1.0, 1.0};
  double pixel_height = 1.0;  ///< height of a pixel, in pixel widths
  Chromaticities chromaticities;
  std::vector<std::string> notices;
  std::size_t samples_at = 0;
};

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

class HdrHeaderReader {
 public:
  HdrHeaderReader(FileBytes file, const std::string& where)
      : text_(reinterpret_cast<const char*>(file.data()), file.size()), where_(where) {}

  HdrHeader read() {
    line();
    for (std::string_view text = line(); !trimmed(text).empty(); text = line()) read_variable(text);
    read_resolution(trimmed(line()));
    header_.samples_at = at_;
    return std::move(header_);
  }

 private:
  std::string_view line() {
    constexpr std::size_t kLongest = 1 << 16;
    const std::size_t end = text_.substr(at_, kLongest).find('\n');
    if (end == std::string_view::npos) throw unreadable_picture(where_, "its header is truncated");
    const std::string_view line = text_.substr(at_, end);
    at_ += end + 1;
    return line;
  }

  /// Reads NAME=value. Ignores other lines, which are comments or commands.
  void read_variable(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return;
    const std::string_view name = text.substr(0, equals), value = trimmed(text.substr(equals + 1));
    if (name == "FORMAT") read_format(value);
    if (name == "EXPOSURE") multiply_exposure(numbers<1>(name, value)[0]);
    if (name == "COLORCORR") multiply_exposure(numbers<3>(name, value));
    if (name == "PIXASPECT") header_.pixel_height *= numbers<1>(name, value)[0];
    if (name == "PRIMARIES" && !is_xyz_) read_primaries(numbers<8>(name, value));
    if (name == "GAMMA" && std::abs(numbers<1>(name, value)[0] - 1.0) > 0.001)
      header_.notices.push_back(
          fmt::format("its GAMMA of {} is not applied: its samples are read as linear", printable(value)));
  }

  void read_format(std::string_view value) {
    is_xyz_ = value == "32-bit_rle_xyze";
    if (!is_xyz_ && value != "32-bit_rle_rgbe")
      throw unreadable_picture(where_, fmt::format("its FORMAT is {}, not 32-bit_rle_rgbe or 32-bit_rle_xyze", shown(value)));
    if (is_xyz_) header_.chromaticities = kXyz;
  }

  template <std::size_t count>
  std::array<double, count> numbers(std::string_view name, std::string_view text) {
    std::array<double, count> values{};
    std::string_view rest = text;
    for (double& value : values) {
      rest = trimmed(rest);
      if (rest.starts_with('+')) rest.remove_prefix(1);
      const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), value);
      if (read.ec != std::errc() || !std::isfinite(value))
        throw unreadable_picture(where_, fmt::format("its {} is {}, not {}", name, shown(text),
                                                     count == 1 ? "a number" : fmt::format("{} numbers", count)));
      rest.remove_prefix(static_cast<std::size_t>(read.ptr - rest.data()));
    }
    return values;
  }

  void multiply_exposure(double factor) { multiply_exposure(std::array{factor, factor, factor}); }
  void multiply_exposure(const std::array<double, 3>& factors) {
    for (std::size_t c = 0; c < 3; ++c) {
      header_.exposure[c] *= factors[c];
      if (!(header_.exposure[c] >= 1e-30 && header_.exposure[c] <= 1e30))
        throw unreadable_picture(
            where_,
            fmt::format("its EXPOSURE and COLORCORR multiply light by {:g}, which cannot be undone", header_.exposure[c]));
    }
  }

  void read_primaries(const std::array<double, 8>& xy) {
    header_.chromaticities = {xy};
    if (rec709_from(header_.chromaticities)) return;
    header_.chromaticities = {};
    header_.notices.emplace_back("its PRIMARIES are invalid and are ignored");
  }

  /// Reads a line such as "-Y 512 +X 768": direction, axis and number of the scan lines, then of the pixels in a scan line.
  void read_resolution(std::string_view text) {
    HdrShape& shape = header_.shape;
    const std::string_view all = text;
    std::array<char, 2> axes{};
    for (char& axis : axes) {
      const bool has_axis = text.size() > 3 && (text[0] == '+' || text[0] == '-') && (text[1] == 'X' || text[1] == 'Y');
      const std::string_view digits = has_axis ? trimmed(text.substr(2)) : "";
      int& side = has_axis && text[1] == 'X' ? shape.width : shape.height;
      const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), side);
      if (!has_axis || read.ec != std::errc())
        throw unreadable_picture(
            where_,
            fmt::format("its resolution is {}, not -Y ROWS +X COLUMNS (other signs and +X first are allowed)", shown(all)));
      axis = text[1];
      (axis == 'X' ? shape.right : shape.down) = (text[0] == '+') == (axis == 'X');
      text = trimmed({read.ptr, static_cast<std::size_t>(text.data() + text.size() - read.ptr)});
    }
    if (axes[0] == axes[1]) throw unreadable_picture(where_, fmt::format("its resolution is {}", shown(all)));
    shape.rows_first = axes[0] == 'Y';
    check_image_size(where_, shape.width, shape.height, 3);
  }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 0;
  bool is_xyz_ = false;
  HdrHeader header_;
};

class HdrLines {
 public:
  HdrLines(FileBytes samples, const std::string& where) : rest_(samples), where_(where) {}

  void read(std::vector<Rgbe>& line) {
    constexpr std::size_t kShortest = 8, kLongest = 0x7fff;
    const bool may_have_runs = line.size() >= kShortest && line.size() <= kLongest && rest_.size() >= 4;
    const auto byte = [&](std::size_t i) { return std::to_integer<std::size_t>(rest_[i]); };
    if (may_have_runs && byte(0) == 2 && byte(1) == 2 && byte(2) < 0x80) {
      if ((byte(2) << 8 | byte(3)) != line.size())
        throw unreadable_picture(where_, "a scan line is not as long as the picture is wide");
      rest_ = rest_.subspan(4);
      for (std::size_t component = 0; component < 4; ++component) read_component(line, component);
    } else {
      read_pixels(line);
    }
  }

 private:
  std::uint8_t next() {
    if (rest_.empty()) throw unreadable_picture(where_, "the file is truncated");
    const auto value = std::to_integer<std::uint8_t>(rest_.front());
    rest_ = rest_.subspan(1);
    return value;
  }

  void read_component(std::vector<Rgbe>& line, std::size_t component) {
    constexpr std::size_t kRun = 128;
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t code = next(), count = code > kRun ? code - kRun : code;
      if (count == 0 || count > line.size() - at)
        throw unreadable_picture(where_, "a run of samples is empty or longer than the rest of its scan line");
      std::uint8_t value = code > kRun ? next() : 0;
      for (std::size_t i = 0; i < count; ++i, ++at) line[at][component] = code > kRun ? value : next();
    }
  }

  /// Reads pixels with runs 1, 1, 1, n. If several runs follow each other, their values n are the base-256 digits of one
  /// length, the lowest digit first.
  void read_pixels(std::vector<Rgbe>& line) {
    int shift = 0;
    for (std::size_t at = 0; at < line.size();) {
      Rgbe pixel;
      for (std::uint8_t& value : pixel) value = next();
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        line[at++] = pixel;
        shift = 0;
        continue;
      }
      const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
      if (at == 0 || shift > 16 || count > line.size() - at)
        throw unreadable_picture(where_, "a run of pixels is longer than the rest of its scan line, or repeats no pixel");
      std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(at), count, line[at - 1]);
      at += count;
      shift += 8;
    }
  }

  FileBytes rest_;
  const std::string& where_;
};

float scale_of(const Rgbe& pixel) { return pixel[3] == 0 ? 0.0f : std::ldexp(1.0f, pixel[3] - (128 + 8)); }

HdrHeader read_hdr_header(FileBytes file, const std::string& where) {
  HdrHeader header = HdrHeaderReader(file, where).read();
  const std::uint64_t pixels = static_cast<std::uint64_t>(header.shape.width) * static_cast<std::uint64_t>(header.shape.height);
  check_file_holds(where, file.size(), sizeof(Rgbe) * pixels, kDeflateRatio);  // run-length coding compresses less
  return header;
}

PictureHeader picture_header_of(const HdrHeader& hdr) {
  PictureHeader header = plain_header(hdr.shape.width, hdr.shape.height, 3, SampleKind::kFloat);
  header.notices = hdr.notices;
  add_aspect_notice(header, 1.0 / hdr.pixel_height);
  return header;
}

}  // namespace

bool is_hdr(FileBytes file) { return file.size() >= 2 && file[0] == std::byte{'#'} && file[1] == std::byte{'?'}; }

PictureHeader hdr_header(FileBytes file, const std::string& where) { return picture_header_of(read_hdr_header(file, where)); }

DecodedPicture decode_hdr(FileBytes file, const std::string& where) {
  const HdrHeader header = read_hdr_header(file, where);
  const HdrShape& shape = header.shape;
  std::vector<float> samples(3 * static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height));
  std::vector<Rgbe> line(static_cast<std::size_t>(shape.line_pixels()));
  HdrLines lines(file.subspan(header.samples_at), where);
  for (int i = 0; i < shape.lines(); ++i) {
    lines.read(line);
    for (int j = 0; j < shape.line_pixels(); ++j) {
      const Rgbe& pixel = line[static_cast<std::size_t>(j)];
      const float scale = scale_of(pixel);
      float* to = &samples[3 * shape.pixel(i, j)];
      for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(pixel[c]) * scale;
    }
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (const double exposure = header.exposure[i % 3]; exposure != 1.0)
      samples[i] = static_cast<float>(static_cast<double>(samples[i]) / exposure);
  if (!are_rec709(header.chromaticities))
    if (const auto matrix = rec709_from(header.chromaticities)) convert_colors(*matrix, samples, 3);
  return {picture_header_of(header), std::move(samples)};
}

}  // namespace lippmann
