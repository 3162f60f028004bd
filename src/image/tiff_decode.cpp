// Decodes TIFF from memory with libtiff.
//
// Grey and RGB samples (8-bit, 16-bit, half, float, double) are read directly with all extra channels, from strips or tiles.
// Other kinds (palettes, 1 to 4 bits, CMYK, YCbCr, fax) use libtiff's conversion to 8-bit RGB.
#include <Imath/half.h>
#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "image/chromaticities.hpp"
#include "image/color_profile.hpp"
#include "image/decode.hpp"
#include "image/icc_transform.hpp"
#include "image/limits.hpp"
#include "image/orientation.hpp"

namespace lippmann {
namespace {

struct TiffDeleter {
  void operator()(TIFF* p) const { TIFFClose(p); }
};
struct OptionsDeleter {
  void operator()(TIFFOpenOptions* p) const { TIFFOpenOptionsFree(p); }
};

struct Layout {
  std::uint16_t channels = 1, bits = 8, format = SAMPLEFORMAT_UINT, planes = PLANARCONFIG_CONTIG, photometric = 0;
  std::uint32_t width = 0, height = 0;
  std::uint32_t block_width = 0, block_height = 0;
  bool direct = false, tiled = false;
  bool inks = false;

  std::size_t sample_bytes() const { return bits / 8u; }
  std::size_t block_channels() const { return planes == PLANARCONFIG_SEPARATE ? 1 : channels; }
};

class TiffDecoder {
 public:
  TiffDecoder(FileBytes file, const std::string& where) : file_(file), where_(where) {
    const std::unique_ptr<TIFFOpenOptions, OptionsDeleter> options(TIFFOpenOptionsAlloc());
    if (!options) throw std::bad_alloc();
    constexpr tmsize_t kMaxAllocation = tmsize_t{1} << 30;
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMaxAllocation);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &on_error, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), &on_warning, this);
    tiff_.reset(TIFFClientOpenExt("memory", "rm", this, &on_read, &on_write, &on_seek, &on_close, &on_size, &on_map, &on_unmap,
                                  options.get()));
    if (!tiff_) throw failure();
    read_layout();
    // libtiff skips tags beyond the end of the file, such as a palette, so that the image would be wrong.
    if (cut_off_) throw unreadable_picture(where_, "the file is truncated");
  }

  PictureHeader header() const {
    PictureHeader header = plain_header(static_cast<int>(layout_.width), static_cast<int>(layout_.height),
                                        layout_.direct ? layout_.channels : 3, kind());
    header.orientation = orientation_of(field<std::uint16_t>(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT));
    add_color_notices(header);
    add_place_notices(header);
    return header;
  }

  /// Converts CMYK to RGB and removes its profile from the header. If the profile cannot be used, adds a notice (8 bits per
  /// sample) or throws Error (16 bits).
  Samples samples(PictureHeader& header) {
    if (layout_.direct) return direct_samples();
    if (layout_.inks && !header.profile.empty()) {
      if (std::optional<Samples> rgb = rgb_of_inks(header.profile, direct_samples())) {
        header.profile.clear();
        return *std::move(rgb);
      }
    }
    if (layout_.inks && layout_.bits == 16)
      throw unreadable_picture(where_, "its inks (CMYK) of 16 bits have no colour profile that can be applied");
    if (layout_.inks) header.profile.clear(), header.notices.emplace_back(kInksNotice);
    return rgb_samples();
  }

 private:
  Samples direct_samples() {
    switch (layout_.bits) {
      case 8:
        return blocks<std::uint8_t, std::uint8_t>();
      case 16:
        if (layout_.format == SAMPLEFORMAT_IEEEFP) return blocks<Imath::half, float>();
        return blocks<std::uint16_t, std::uint16_t>();
      case 32:
        return blocks<float, float>();
      default:
        return blocks<double, float>();
    }
  }

  static int on_error(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    TiffDecoder& decoder = *static_cast<TiffDecoder*>(user);
    if (decoder.reason_[0] == 0) std::vsnprintf(decoder.reason_.data(), decoder.reason_.size(), format, arguments);
    return 1;
  }
  /// libtiff 4.5.1 only warns if a tag lies beyond the end of the file.
  static int on_warning(TIFF*, void* user, const char*, const char* format, va_list) {
    const std::string_view text(format);
    if (text.starts_with("IO error during reading of") || text.starts_with("Requested memory size for tag"))
      static_cast<TiffDecoder*>(user)->cut_off_ = true;
    return 1;
  }
  static tmsize_t on_read(thandle_t user, void* to, tmsize_t count) {
    TiffDecoder& decoder = *static_cast<TiffDecoder*>(user);
    const std::uint64_t there = decoder.at_ < decoder.file_.size() ? decoder.file_.size() - decoder.at_ : 0;
    const auto taken = std::min<std::uint64_t>(there, static_cast<std::uint64_t>(std::max<tmsize_t>(count, 0)));
    if (taken > 0) std::memcpy(to, decoder.file_.data() + decoder.at_, taken);
    decoder.at_ += taken;
    decoder.cut_off_ = decoder.cut_off_ || taken < static_cast<std::uint64_t>(count);
    return static_cast<tmsize_t>(taken);
  }
  static tmsize_t on_write(thandle_t, void*, tmsize_t) { return 0; }
  static toff_t on_seek(thandle_t user, toff_t offset, int whence) {
    TiffDecoder& decoder = *static_cast<TiffDecoder*>(user);
    const std::uint64_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? decoder.at_ : decoder.file_.size();
    return decoder.at_ = from + offset;
  }
  static int on_close(thandle_t) { return 0; }
  static toff_t on_size(thandle_t user) { return static_cast<TiffDecoder*>(user)->file_.size(); }
  static int on_map(thandle_t, void**, toff_t*) { return 0; }
  static void on_unmap(thandle_t, void*, toff_t) {}

  Error failure() const { return unreadable_picture(where_, reason_[0] ? reason_.data() : "the file is truncated or damaged"); }

  template <class T>
  T field(std::uint32_t tag, T standard) const {
    T value = standard;
    return TIFFGetFieldDefaulted(tiff_.get(), tag, &value) ? value : standard;
  }

  template <class T>
  const T* array_field(std::uint32_t tag) const {
    const T* values = nullptr;
    return TIFFGetField(tiff_.get(), tag, &values) ? values : nullptr;
  }

  void add_color_notices(PictureHeader& header) const {
    std::uint32_t size = 0;
    const void* profile = nullptr;
    if (TIFFGetField(tiff_.get(), TIFFTAG_ICCPROFILE, &size, &profile) && profile) {
      header.profile = profile_to_apply({static_cast<const std::byte*>(profile), size});
      return;
    }
    Chromaticities chromaticities;
    if (const float* primaries = array_field<float>(TIFFTAG_PRIMARYCHROMATICITIES))
      std::copy_n(primaries, 6, chromaticities.xy.begin());
    if (const float* white = array_field<float>(TIFFTAG_WHITEPOINT)) std::copy_n(white, 2, chromaticities.xy.begin() + 6);
    if (!are_rec709(chromaticities))
      header.notices.emplace_back("its chromaticities are not applied: its colours are read as sRGB");
  }

  void add_place_notices(PictureHeader& header) const {
    float across = 0.0f, down = 0.0f;
    if (TIFFGetField(tiff_.get(), TIFFTAG_XRESOLUTION, &across) && TIFFGetField(tiff_.get(), TIFFTAG_YRESOLUTION, &down) &&
        across > 0.0f && down > 0.0f)
      add_aspect_notice(header, static_cast<double>(down) / static_cast<double>(across));
    std::uint32_t whole_width = layout_.width, whole_height = layout_.height;
    TIFFGetField(tiff_.get(), TIFFTAG_PIXAR_IMAGEFULLWIDTH, &whole_width);
    TIFFGetField(tiff_.get(), TIFFTAG_PIXAR_IMAGEFULLLENGTH, &whole_height);
    if (whole_width != layout_.width || whole_height != layout_.height)
      header.notices.push_back(
          fmt::format("it is a part of a picture of {} x {} pixels and is read on its own", whole_width, whole_height));
  }

  SampleKind kind() const {
    if (layout_.bits == 8 || !(layout_.direct || layout_.inks)) return SampleKind::kByte;
    return layout_.format == SAMPLEFORMAT_IEEEFP ? SampleKind::kFloat : SampleKind::kWord;
  }

  std::uint64_t ratio() const {
    switch (field<std::uint16_t>(TIFFTAG_COMPRESSION, COMPRESSION_NONE)) {
      case COMPRESSION_NONE:
        return 1;
      case COMPRESSION_PACKBITS:
        return 128;
      case COMPRESSION_LZW:
        return 4096;
      case COMPRESSION_DEFLATE:
      case COMPRESSION_ADOBE_DEFLATE:
        return kDeflateRatio;
      default:
        return std::uint64_t{1} << 16;
    }
  }

  void read_layout() {
    Layout& l = layout_;
    l.width = field<std::uint32_t>(TIFFTAG_IMAGEWIDTH, 0), l.height = field<std::uint32_t>(TIFFTAG_IMAGELENGTH, 0);
    l.channels = field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, 1);
    l.bits = field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, 1);
    l.format = field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    l.planes = field<std::uint16_t>(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    l.photometric = field<std::uint16_t>(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    l.tiled = TIFFIsTiled(tiff_.get());
    l.block_width = l.tiled ? field<std::uint32_t>(TIFFTAG_TILEWIDTH, 0) : l.width;
    l.block_height = l.tiled ? field<std::uint32_t>(TIFFTAG_TILELENGTH, 0)
                             : std::min(field<std::uint32_t>(TIFFTAG_ROWSPERSTRIP, l.height), l.height);
    check_image_size(where_, l.width, l.height, l.channels);
    const bool whole = l.format == SAMPLEFORMAT_UINT && (l.bits == 8 || l.bits == 16);
    const bool real = l.format == SAMPLEFORMAT_IEEEFP && (l.bits == 16 || l.bits == 32 || l.bits == 64);
    const bool plain = l.photometric == PHOTOMETRIC_MINISBLACK || l.photometric == PHOTOMETRIC_MINISWHITE ||
                       (l.photometric == PHOTOMETRIC_RGB && l.channels >= 3);
    l.direct = (whole || real) && plain;
    l.inks = whole && l.photometric == PHOTOMETRIC_SEPARATED && l.channels == 4 &&
             field<std::uint16_t>(TIFFTAG_INKSET, INKSET_CMYK) == INKSET_CMYK;
    const std::uint64_t pixels = std::uint64_t{l.width} * l.height, bits = std::uint64_t{l.bits} * l.channels;
    check_file_holds(where_, file_.size(), l.direct ? pixels * (bits / 8) : pixels * bits / 8, ratio());
    const std::uint64_t block = std::uint64_t{l.block_width} * l.block_height * (bits / 8 + 1);
    const std::uint64_t largest = std::max<std::uint64_t>(std::uint64_t{1} << 24, 4 * pixels * (bits / 8 + 1));
    if (block == 0 || block > largest) throw unreadable_picture(where_, "its tile size is invalid");
  }

  template <class Stored, class Sample>
  std::vector<Sample> blocks() {
    const Layout& l = layout_;
    const std::size_t pixels = std::size_t{l.width} * l.height, step = l.block_channels();
    std::vector<Sample> samples(pixels * l.channels);
    const auto block_bytes = static_cast<std::size_t>(l.tiled ? TIFFTileSize(tiff_.get()) : TIFFStripSize(tiff_.get()));
    if (block_bytes != std::size_t{l.block_width} * l.block_height * step * sizeof(Stored)) throw failure();
    std::vector<Stored> block(block_bytes / sizeof(Stored));
    for (std::size_t plane = 0; plane < l.channels / step; ++plane)
      for (std::uint32_t y = 0; y < l.height; y += l.block_height)
        for (std::uint32_t x = 0; x < l.width; x += l.block_width) {
          const std::uint32_t rows = std::min(l.block_height, l.height - y), columns = std::min(l.block_width, l.width - x);
          read_block(x, y, static_cast<std::uint16_t>(plane), rows, block.data(), block_bytes);
          for (std::uint32_t row = 0; row < rows; ++row)
            for (std::size_t i = 0; i < columns * step; ++i) {
              const std::size_t pixel = (std::size_t{y} + row) * l.width + x + i / step;
              samples[pixel * l.channels + plane + i % step] =
                  static_cast<Sample>(block[std::size_t{row} * l.block_width * step + i]);
            }
        }
    if (l.photometric == PHOTOMETRIC_MINISWHITE && l.format == SAMPLEFORMAT_UINT)
      for (std::size_t i = 0; i < samples.size(); i += l.channels)
        samples[i] = static_cast<Sample>(((1 << l.bits) - 1) - samples[i]);
    return samples;
  }

  void read_block(std::uint32_t x, std::uint32_t y, std::uint16_t plane, std::uint32_t rows, void* to, std::size_t bytes) {
    TIFF* tiff = tiff_.get();
    const std::size_t needed = layout_.tiled ? bytes : bytes / layout_.block_height * rows;
    const tmsize_t read =
        layout_.tiled ? TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, x, y, 0, plane), to, static_cast<tmsize_t>(bytes))
                      : TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, y, plane), to, static_cast<tmsize_t>(needed));
    if (read < 0 || static_cast<std::size_t>(read) < needed) throw failure();
  }

  Samples rgb_samples() {
    const std::size_t pixels = std::size_t{layout_.width} * layout_.height;
    std::vector<std::uint32_t> packed(pixels);
    TIFFRGBAImage conversion{};
    std::array<char, 1024> reason{};
    if (!TIFFRGBAImageOK(tiff_.get(), reason.data()) || !TIFFRGBAImageBegin(&conversion, tiff_.get(), 1, reason.data()))
      throw unreadable_picture(where_, reason.data());
    conversion.req_orientation = conversion.orientation;  // keeps the stored order of samples
    const bool converted = TIFFRGBAImageGet(&conversion, packed.data(), layout_.width, layout_.height);
    TIFFRGBAImageEnd(&conversion);
    if (!converted) throw failure();
    std::vector<std::uint8_t> codes;
    codes.reserve(3 * pixels);
    for (const std::uint32_t p : packed)
      for (const std::uint32_t code : {TIFFGetR(p), TIFFGetG(p), TIFFGetB(p)}) codes.push_back(static_cast<std::uint8_t>(code));
    return codes;
  }

  FileBytes file_;
  std::uint64_t at_ = 0;
  bool cut_off_ = false;  // a read went beyond the end of the file
  const std::string& where_;
  std::array<char, 256> reason_{};
  std::unique_ptr<TIFF, TiffDeleter> tiff_;
  Layout layout_;
};

}  // namespace

bool is_tiff(FileBytes file) {
  if (file.size() < 4) return false;
  const auto begins = [&](const char(&magic)[5]) { return std::memcmp(file.data(), magic, 4) == 0; };
  return begins("II*\0") || begins("MM\0*") || begins("II+\0") || begins("MM\0+");
}

PictureHeader tiff_header(FileBytes file, const std::string& where) { return TiffDecoder(file, where).header(); }

DecodedPicture decode_tiff(FileBytes file, const std::string& where) {
  TiffDecoder decoder(file, where);
  PictureHeader header = decoder.header();
  Samples samples = decoder.samples(header);
  return {std::move(header), std::move(samples)};
}

}  // namespace lippmann
