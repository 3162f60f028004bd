// TGA, which Tachyon's scenes use for image maps: grey and true colour of 8, 24 and 32 bits, with or without runs.
//
// Based on: Truevision, "TGA File Format Specification", version 2.0, 1991: 18 bytes of header, then rows from the bottom
// unless a bit says otherwise, pixels as B, G, R(, A).
// We deviate: palettes, 16-bit pixels and rows from the right are refused.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "image/decode.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kHeaderBytes = 18;

struct Header {
  unsigned id_length, palette, kind, width, height, bits, descriptor;
  bool runs() const { return kind >= 8; }
  bool grey() const { return kind % 8 == 3; }
};

Header parse(FileBytes file) {
  const auto byte = [&](std::size_t at) { return std::to_integer<unsigned>(file[at]); };
  return {byte(0), byte(1), byte(2), byte(12) | byte(13) << 8, byte(14) | byte(15) << 8, byte(16), byte(17)};
}

/// Of known kinds. A pixel of 32 bits has alpha where the descriptor says that bits of it are.
std::size_t bytes_per_pixel(const Header& header) { return header.bits / 8; }
int channels_of(const Header& header) { return header.grey() ? 1 : header.bits == 32 && header.descriptor % 16 != 0 ? 4 : 3; }

/// Pixels in the file's order.
std::vector<std::uint8_t> unpack(FileBytes rest, std::size_t pixels, std::size_t pixel_bytes, bool runs,
                                 const std::string& where) {
  std::vector<std::uint8_t> stored(pixels * pixel_bytes);
  const auto take = [&](std::size_t count) {
    if (count > rest.size()) throw unreadable_picture(where, "the file is truncated");
    const std::byte* from = rest.data();
    rest = rest.subspan(count);
    return from;
  };
  if (!runs) {
    std::memcpy(stored.data(), take(stored.size()), stored.size());
    return stored;
  }
  for (std::size_t at = 0; at < stored.size();) {
    const auto code = std::to_integer<unsigned>(*take(1));
    const std::size_t count = std::min((code % 128 + 1) * pixel_bytes, stored.size() - at);
    if (code < 128) {
      std::memcpy(&stored[at], take(count), count);
    } else {
      const std::byte* pixel = take(pixel_bytes);
      for (std::size_t i = 0; i < count; i += pixel_bytes) std::memcpy(&stored[at + i], pixel, pixel_bytes);
    }
    at += count;
  }
  return stored;
}

}  // namespace

bool is_tga(FileBytes file) {
  if (file.size() < kHeaderBytes) return false;
  const Header header = parse(file);
  const bool colour = header.kind % 8 == 2 && (header.bits == 24 || header.bits == 32),
             grey = header.grey() && header.bits == 8;
  const bool known = header.kind == 2 || header.kind == 3 || header.kind == 10 || header.kind == 11;
  return header.palette == 0 && known && (colour || grey) && header.descriptor < 64 && (header.descriptor & 16) == 0 &&
         header.width > 0 && header.height > 0;
}

PictureHeader tga_header(FileBytes file, const std::string& where) {
  const Header header = parse(file);
  const int channels = channels_of(header), width = static_cast<int>(header.width), height = static_cast<int>(header.height);
  check_image_size(where, width, height, channels);
  const std::uint64_t bytes = bytes_per_pixel(header) * header.width * header.height;
  check_file_holds(where, file.size(), bytes, header.runs() ? 128 : 1);
  return {width, height, default_channels(channels), SampleKind::kByte};
}

DecodedPicture decode_tga(FileBytes file, const std::string& where) {
  PictureHeader picture = tga_header(file, where);
  const Header header = parse(file);
  const std::size_t width = header.width, height = header.height, from = bytes_per_pixel(header), to = picture.channels.size();
  const std::size_t begin = std::min(kHeaderBytes + header.id_length, file.size());
  const std::vector<std::uint8_t> stored = unpack(file.subspan(begin), width * height, from, header.runs(), where);
  std::vector<std::uint8_t> codes(width * height * to);
  const bool top_first = header.descriptor & 32;
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const std::uint8_t* pixel = &stored[((top_first ? y : height - 1 - y) * width + x) * from];
      std::uint8_t* code = &codes[(y * width + x) * to];
      for (std::size_t c = 0; c < to; ++c) code[c] = pixel[c < 3 && to >= 3 ? 2 - c : c];
    }
  return {std::move(picture), std::move(codes)};
}

}  // namespace lippmann
