// Decodes PNG with libpng. libpng reports errors with longjmp(), so no object with a destructor may be created between setjmp()
// and a call that may fail. Therefore PngDecoder owns all memory.
#include <fmt/format.h>
#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>

#include "image/chromaticities.hpp"
#include "image/color_profile.hpp"
#include "image/decode.hpp"
#include "image/exif.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

constexpr unsigned char kPngMagic[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// cICP chunk of sRGB: primaries, transfer curve, matrix and full range (numbers of ITU-T H.273).
constexpr std::array<std::uint8_t, 4> kSrgbCodingPoints{1, 13, 0, 1};

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
    constexpr png_alloc_size_t kMaxChunk = 8 << 20;  // largest chunk in bytes, such as a profile or a text
    png_set_chunk_malloc_max(png_, kMaxChunk);
    read_unknown_chunks(file);
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
    PictureHeader header =
        plain_header(width, height, channels, png_get_bit_depth(png_, info_) == 16 ? SampleKind::kWord : SampleKind::kByte);
    header.orientation = orientation();
    header.profile = profile();
    header.notices = color_notices();
    if (is_animated_) header.notices.emplace_back("it is animated: only its first picture is read");
    add_place_notices(header);
    return header;
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

  Orientation orientation() const {
    png_uint_32 size = 0;
    png_bytep exif = nullptr;
    if (!png_get_eXIf_1(png_, info_, &size, &exif)) return Orientation::kUpright;
    return exif_orientation(std::as_bytes(std::span(exif, size)));
  }

  std::vector<std::byte> profile() const {
    png_charp name = nullptr;
    int compression = 0;
    png_bytep profile = nullptr;
    png_uint_32 size = 0;
    if (coding_points_ || !png_get_iCCP(png_, info_, &name, &compression, &profile, &size)) return {};
    return profile_to_apply(std::as_bytes(std::span(profile, size)));
  }

  /// cICP overrides iCCP, which overrides sRGB, which overrides gAMA and cHRM.
  std::vector<std::string> color_notices() const {
    constexpr std::string_view kReadAsSrgb = "are not applied: its codes are read as sRGB";
    if (coding_points_ && *coding_points_ != kSrgbCodingPoints) return {fmt::format("its colours (cICP) {}", kReadAsSrgb)};
    if (coding_points_) return {};
    if (png_get_valid(png_, info_, PNG_INFO_iCCP)) return {};
    int intent = 0;
    if (png_get_sRGB(png_, info_, &intent)) return {};
    std::vector<std::string> notices;
    double gamma = 0.0;
    constexpr double kSrgbGamma = 0.45455, kRounded = 0.005;
    if (png_get_gAMA(png_, info_, &gamma) && std::abs(gamma - kSrgbGamma) > kRounded)
      notices.push_back(fmt::format("its gamma (gAMA {:g}) is not applied: its codes are read as sRGB", gamma));
    std::array<double, 8> xy{};  // x and y of red, green, blue and white; png_get_cHRM() returns white first
    if (png_get_cHRM(png_, info_, &xy[6], &xy[7], &xy[0], &xy[1], &xy[2], &xy[3], &xy[4], &xy[5]) && !are_rec709({xy}))
      notices.push_back(fmt::format("its chromaticities (cHRM) {}", kReadAsSrgb));
    return notices;
  }

  void add_place_notices(PictureHeader& header) const {
    png_uint_32 across = 0, down = 0;
    int unit = 0;
    if (png_get_pHYs(png_, info_, &across, &down, &unit) && across > 0 && down > 0)
      add_aspect_notice(header, static_cast<double>(down) / across);
    png_int_32 x = 0, y = 0;
    if (png_get_oFFs(png_, info_, &x, &y, &unit) && (x != 0 || y != 0))
      header.notices.push_back(fmt::format("its offset (oFFs) of {}, {} is ignored", x, y));
  }

  /// Older versions of libpng do not support acTL and cICP.
  void read_unknown_chunks(FileBytes file) {
    for (std::size_t at = sizeof kPngMagic; at + 12 <= file.size();) {
      std::uint32_t size = 0;
      for (std::size_t i = 0; i < 4; ++i) size = size << 8 | std::to_integer<std::uint32_t>(file[at + i]);
      const std::string_view name(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
      if (name == "IDAT" || size > file.size() - at - 12) return;
      if (name == "acTL") is_animated_ = true;
      if (name == "cICP" && size == 4) coding_points_.emplace(), std::memcpy(coding_points_->data(), &file[at + 8], 4);
      at += 12 + std::size_t{size};
    }
  }

  bool read_header() {
    if (setjmp(back_) != 0) return false;
    png_read_info(png_, info_);
    packed_bytes_ = static_cast<std::uint64_t>(png_get_rowbytes(png_, info_)) * png_get_image_height(png_, info_);
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY && png_get_bit_depth(png_, info_) < 8)
      png_set_expand_gray_1_2_4_to_8(png_);
    if (png_get_valid(png_, info_, PNG_INFO_tRNS)) png_set_tRNS_to_alpha(png_);
    if (png_get_bit_depth(png_, info_) == 16) png_set_swap(png_);  // converts to little-endian
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
  std::optional<std::array<std::uint8_t, 4>> coding_points_;
  bool is_animated_ = false;
  std::uint64_t packed_bytes_ = 0;  // bytes of all rows before compression, with pixels below 8 bits packed
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
