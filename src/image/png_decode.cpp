// PNG, by libpng. Its errors jump: what lies between setjmp() and them has no destructors, and everything that owns memory
// lives in the PngDecoder around it.
#include <png.h>

#include <csetjmp>
#include <cstring>

#include "image/decode.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

constexpr unsigned char kPngMagic[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

class PngDecoder {
 public:
  PngDecoder(FileBytes file, const std::string& where) : rest_(file), size_(file.size()), where_(where) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &on_error, &on_warning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, this, &on_read);
    png_set_user_limits(png_, kMaxImageSide, kMaxImageSide);
    constexpr png_alloc_size_t kMaxChunk = 8 << 20;  // profiles and texts, which are not used
    png_set_chunk_malloc_max(png_, kMaxChunk);
  }
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;

  PictureHeader header() {
    if (!read_header()) throw unreadable_picture(where_, reason_);
    const int width = static_cast<int>(png_get_image_width(png_, info_)),
              height = static_cast<int>(png_get_image_height(png_, info_));
    const int channels = png_get_channels(png_, info_);
    check_image_size(where_, width, height, channels);
    check_file_holds(where_, size_, packed_bytes_, kDeflateRatio);
    return {width, height, default_channels(channels),
            png_get_bit_depth(png_, info_) == 16 ? SampleKind::kWord : SampleKind::kByte};
  }

  template <class Code>
  std::vector<Code> samples(const PictureHeader& header) {
    const std::size_t row = header.channels.size() * static_cast<std::size_t>(header.width);
    std::vector<Code> codes(row * static_cast<std::size_t>(header.height));
    std::vector<png_bytep> rows(static_cast<std::size_t>(header.height));
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = reinterpret_cast<png_bytep>(codes.data() + row * y);
    if (!read_rows(rows.data())) throw unreadable_picture(where_, reason_);
    return codes;
  }

 private:
  static PngDecoder& of(png_structp png) { return *static_cast<PngDecoder*>(png_get_error_ptr(png)); }
  [[noreturn]] static void on_error(png_structp png, png_const_charp text) {
    PngDecoder& decoder = of(png);
    std::strncpy(decoder.reason_, text, sizeof decoder.reason_ - 1);
    std::longjmp(decoder.back_, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}
  static void on_read(png_structp png, png_bytep to, std::size_t count) {
    PngDecoder& decoder = *static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (count > decoder.rest_.size()) png_error(png, "the file is truncated");
    std::memcpy(to, decoder.rest_.data(), count);
    decoder.rest_ = decoder.rest_.subspan(count);
  }

  bool read_header() {
    if (setjmp(back_) != 0) return false;
    png_read_info(png_, info_);
    packed_bytes_ = static_cast<std::uint64_t>(png_get_rowbytes(png_, info_)) * png_get_image_height(png_, info_);
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY && png_get_bit_depth(png_, info_) < 8)
      png_set_expand_gray_1_2_4_to_8(png_);
    if (png_get_valid(png_, info_, PNG_INFO_tRNS)) png_set_tRNS_to_alpha(png_);
    if (png_get_bit_depth(png_, info_) == 16) png_set_swap(png_);  // this machine's low byte comes first
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  bool read_rows(png_bytepp rows) {
    if (setjmp(back_) != 0) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  FileBytes rest_;
  std::size_t size_;
  const std::string& where_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::uint64_t packed_bytes_ = 0;  // what all rows take, as the file has them
  char reason_[200] = {};
  std::jmp_buf back_;
};

}  // namespace

bool is_png(FileBytes file) {
  return file.size() >= sizeof kPngMagic && std::memcmp(file.data(), kPngMagic, sizeof kPngMagic) == 0;
}

PictureHeader png_header(FileBytes file, const std::string& where) { return PngDecoder(file, where).header(); }

DecodedPicture decode_png(FileBytes file, const std::string& where) {
  PngDecoder decoder(file, where);
  const PictureHeader header = decoder.header();
  if (header.kind == SampleKind::kWord) return {header, decoder.samples<std::uint16_t>(header)};
  return {header, decoder.samples<std::uint8_t>(header)};
}

}  // namespace lippmann
