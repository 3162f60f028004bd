// Decodes BMP, GIF and TGA with stb_image.
//
// stb_image reads zeros beyond the end of a file. StbInput supplies bytes of value 1 instead and marks the file as truncated.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

#include "image/decode.hpp"
#include "image/limits.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_GIF
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#define STBI_MAX_DIMENSIONS 65536
#include <stb_image.h>

namespace lippmann {
namespace {

static_assert(STBI_MAX_DIMENSIONS == kMaxImageSide);

constexpr std::size_t kLongestHeader = 1 << 20;

struct Freed {
  void operator()(void* p) const { stbi_image_free(p); }
};

class StbInput {
 public:
  explicit StbInput(FileBytes file) : rest_(file) {}

  static int read(void* user, char* to, int size) {
    StbInput& input = *static_cast<StbInput*>(user);
    const auto wanted = static_cast<std::size_t>(std::max(size, 0)), there = std::min(wanted, input.rest_.size());
    std::memcpy(to, input.rest_.data(), there);
    input.rest_ = input.rest_.subspan(there);
    // Only reads of kBuffer bytes, which fill stb_image's buffer, may return fewer bytes at the end of the file.
    constexpr std::size_t kBuffer = sizeof(stbi__context::buffer_start);
    if (there == wanted || (there > 0 && wanted == kBuffer)) return static_cast<int>(there);
    input.truncated_ = true;
    std::memset(to + there, 1, wanted - there);
    return size;
  }
  static void skip(void* user, int count) {
    StbInput& input = *static_cast<StbInput*>(user);
    const auto wanted = static_cast<std::size_t>(std::max(count, 0)), there = std::min(wanted, input.rest_.size());
    input.rest_ = input.rest_.subspan(there);
    input.truncated_ = input.truncated_ || there < wanted;
  }
  static int at_end(void* user) { return static_cast<StbInput*>(user)->rest_.empty(); }

  bool truncated() const { return truncated_; }

 private:
  FileBytes rest_;
  bool truncated_ = false;
};

struct Shape {
  int width = 0, height = 0, channels = 0;
};

bool read_shape(FileBytes file, Shape& shape) {
  const auto size = static_cast<int>(std::min(file.size(), kLongestHeader));
  return stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(file.data()), size, &shape.width, &shape.height,
                               &shape.channels) != 0;
}

Shape shape_of(FileBytes file, const std::string& where) {
  Shape shape;
  if (!read_shape(file, shape)) throw unreadable_picture(where, "its header is truncated, damaged or of an unknown kind");
  check_image_size(where, shape.width, std::abs(std::int64_t{shape.height}), shape.channels);
  shape.height = std::abs(shape.height);  // BMP files with rows from the top have a negative height
  return shape;
}

std::uint64_t pixels_of(const Shape& shape) {
  return static_cast<std::uint64_t>(shape.width) * static_cast<std::uint64_t>(shape.height);
}

/// `load` is a function of stb_image that reads through callbacks.
template <class Sample, class Load>
DecodedPicture decode(FileBytes file, const std::string& where, PictureHeader header, const Load& load) {
  constexpr stbi_io_callbacks kCallbacks{&StbInput::read, &StbInput::skip, &StbInput::at_end};
  StbInput input(file);
  Shape shape;
  const std::unique_ptr<Sample[], Freed> samples(load(&kCallbacks, &input, &shape.width, &shape.height, &shape.channels, 0));
  if (input.truncated()) throw unreadable_picture(where, "the file is truncated");
  if (!samples) throw unreadable_picture(where, stbi_failure_reason());
  if (shape.width != header.width || shape.height != header.height ||
      header.channels.size() != static_cast<std::size_t>(shape.channels))
    throw unreadable_picture(where, "its header is damaged");
  const std::size_t count = pixels_of(shape) * header.channels.size();
  return {std::move(header), std::vector<Sample>(samples.get(), samples.get() + count)};
}

std::uint64_t byte_at(FileBytes file, std::size_t at) { return std::to_integer<std::uint64_t>(file[at]); }

/// Reads a signed little-endian integer of 32 bits.
std::int64_t long_at(FileBytes file, std::size_t at) {
  std::int32_t value;
  std::memcpy(&value, file.data() + at, sizeof value);
  return value;
}

}  // namespace

constexpr std::size_t kBmpHeaderBytes = 54, kOldBmpHeaderBytes = 26;

bool is_bmp(FileBytes file) {
  return file.size() >= 18 && byte_at(file, 0) == 'B' && byte_at(file, 1) == 'M' && long_at(file, 14) >= 12 &&
         long_at(file, 14) <= 124;
}

PictureHeader bmp_header(FileBytes file, const std::string& where) {
  const Shape shape = shape_of(file, where);
  const bool old = long_at(file, 14) == 12;  // header of OS/2
  if (file.size() < (old ? kOldBmpHeaderBytes : kBmpHeaderBytes)) throw unreadable_picture(where, "the file is truncated");
  const std::uint64_t bits = byte_at(file, old ? 24 : 28);
  check_file_holds(where, file.size(), pixels_of(shape) * bits / 8, 1);
  PictureHeader header = plain_header(shape.width, shape.height, shape.channels, SampleKind::kByte);
  const std::int64_t across = old ? 0 : long_at(file, 38), down = old ? 0 : long_at(file, 42);
  if (across > 0 && down > 0) add_aspect_notice(header, static_cast<double>(down) / static_cast<double>(across));
  return header;
}

DecodedPicture decode_bmp(FileBytes file, const std::string& where) {
  return decode<std::uint8_t>(file, where, bmp_header(file, where), stbi_load_from_callbacks);
}

namespace {

struct GifContent {
  int pictures = 0;        ///< number of images; 2 means two or more
  bool is_whole = false;   ///< the file has a trailer or a second image
  bool is_opaque = false;  ///< the first image covers the canvas and has no transparent colour
};

/// Based on: CompuServe, "Graphics Interchange Format, Version 89a", 1990. A file is a header of 13 bytes, a colour table and
/// blocks. A block is an extension (0x21) or an image (0x2c), and ends with a list of sub-blocks. A sub-block is a size (one
/// byte) and its data. The last one has size 0.
class GifBlocks {
 public:
  explicit GifBlocks(FileBytes file) : file_(file) {}

  GifContent content() {
    constexpr std::uint64_t kExtension = 0x21, kPicture = 0x2c, kTrailer = 0x3b, kGraphicControl = 0xf9;
    GifContent content;
    bool is_transparent = false;
    at_ = 13 + color_table_bytes(10);
    while (content.pictures < 2) {
      const std::uint64_t kind = byte(at_);
      if (kind == kExtension) {
        if (byte(at_ + 1) == kGraphicControl) is_transparent = (byte(at_ + 3) & 1) != 0;
        at_ += 2;
      } else if (kind == kPicture) {
        if (++content.pictures == 1) content.is_opaque = !is_transparent && covers_canvas();
        at_ += 10 + color_table_bytes(at_ + 9) + 1;
      } else {
        content.is_whole = kind == kTrailer;
        return content;
      }
      skip_sub_blocks();
    }
    content.is_whole = true;
    return content;
  }

 private:
  std::uint64_t byte(std::size_t at) const { return at < file_.size() ? byte_at(file_, at) : 0; }

  std::size_t color_table_bytes(std::size_t flags_at) const {
    const std::uint64_t flags = byte(flags_at);
    return flags & 0x80 ? std::size_t{6} << (flags & 7) : 0;
  }

  bool covers_canvas() const {
    for (std::size_t i = 0; i < 4; ++i)
      if (byte(at_ + 1 + i) != 0 || byte(at_ + 5 + i) != byte(6 + i)) return false;
    return true;
  }

  void skip_sub_blocks() {
    while (const std::uint64_t size = byte(at_)) at_ += 1 + size;
    ++at_;
  }

  FileBytes file_;
  std::size_t at_ = 0;
};

}  // namespace

bool is_gif(FileBytes file) {
  return file.size() >= 6 && (std::memcmp(file.data(), "GIF87a", 6) == 0 || std::memcmp(file.data(), "GIF89a", 6) == 0);
}

PictureHeader gif_header(FileBytes file, const std::string& where) {
  constexpr std::size_t kGifHeaderBytes = 13;
  if (file.size() < kGifHeaderBytes) throw unreadable_picture(where, "the file is truncated");
  const Shape shape = shape_of(file, where);
  // An LZW code of n bits stands for at most 2^n pixels. The codes of GIF have at most 12 bits, so a byte stands for fewer than
  // 4096 pixels.
  constexpr std::uint64_t kMaxGifPixelsPerByte = 4096;
  check_file_holds(where, file.size(), pixels_of(shape), kMaxGifPixelsPerByte);
  const GifContent content = GifBlocks(file).content();
  if (!content.is_whole) throw unreadable_picture(where, "the file is truncated or damaged");
  if (content.pictures == 0) throw unreadable_picture(where, "there is no picture in it");
  PictureHeader header = plain_header(shape.width, shape.height, content.is_opaque ? 3 : 4, SampleKind::kByte);
  if (content.pictures > 1) header.notices.emplace_back("it is animated: only its first picture is read");
  return header;
}

DecodedPicture decode_gif(FileBytes file, const std::string& where) {
  const PictureHeader header = gif_header(file, where);
  const int channels = static_cast<int>(header.channels.size());
  const auto load = [&](const stbi_io_callbacks* calls, void* user, int* width, int* height, int* read, int) {
    stbi_uc* samples = stbi_load_from_callbacks(calls, user, width, height, read, channels);
    *read = channels;  // stb_image always reports 4
    return samples;
  };
  return decode<std::uint8_t>(file, where, header, load);
}

bool is_tga(FileBytes file) {
  constexpr std::size_t kHeaderBytes = 18;
  Shape shape;
  return file.size() >= kHeaderBytes && read_shape(file, shape);
}

PictureHeader tga_header(FileBytes file, const std::string& where) {
  const Shape shape = shape_of(file, where);
  const bool runs = std::to_integer<int>(file[2]) >= 8;
  const std::uint64_t bits_per_pixel = byte_at(file, 16);  // 15 bits take two bytes of the file
  const std::uint64_t begin = 18u + byte_at(file, 0);
  constexpr std::uint64_t kMaxPixelsPerByte = 128;
  check_file_holds(where, file.size() - std::min<std::uint64_t>(begin, file.size()),
                   pixels_of(shape) * ((bits_per_pixel + 7) / 8), runs ? kMaxPixelsPerByte : 1);
  PictureHeader header = plain_header(shape.width, shape.height, shape.channels, SampleKind::kByte);
  constexpr std::uint64_t kFromTheRight = 0x10;  // stb_image ignores this bit, which reverses the columns
  if (byte_at(file, 17) & kFromTheRight) header.orientation = Orientation::kMirrored;
  return header;
}

DecodedPicture decode_tga(FileBytes file, const std::string& where) {
  return decode<std::uint8_t>(file, where, tga_header(file, where), stbi_load_from_callbacks);
}

}  // namespace lippmann
