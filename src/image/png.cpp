#include "image/png.hpp"

#include <png.h>
#include <zlib.h>

#include <cassert>
#include <csetjmp>
#include <cstring>
#include <string>
#include <utility>

#include "core/atomic_file.hpp"
#include "image/limits.hpp"
#include "image/rgba.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

int zlib_strategy(PngStrategy strategy) {
  switch (strategy) {
    case PngStrategy::kDefault:
      return Z_DEFAULT_STRATEGY;
    case PngStrategy::kFiltered:
      return Z_FILTERED;
    case PngStrategy::kRunLength:
      return Z_RLE;
    case PngStrategy::kHuffman:
      return Z_HUFFMAN_ONLY;
  }
  return Z_DEFAULT_STRATEGY;
}

int libpng_bits(PngFilter filter) {
  switch (filter) {
    case PngFilter::kNone:
      return PNG_FILTER_NONE;
    case PngFilter::kLeft:
      return PNG_FILTER_SUB;
    case PngFilter::kUp:
      return PNG_FILTER_UP;
    case PngFilter::kAverage:
      return PNG_FILTER_AVG;
    case PngFilter::kPaeth:
      return PNG_FILTER_PAETH;
    case PngFilter::kAdaptive:
      return PNG_ALL_FILTERS;
  }
  return PNG_FILTER_NONE;
}

struct PngFormat {
  int width, height, bits;
  int channels;  ///< 1: grey, 3: RGB, 4: RGB and alpha

  int color_type() const {
    return channels == 1 ? PNG_COLOR_TYPE_GRAY : channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA;
  }
};

/// libpng reports errors with longjmp(), so no object with a destructor may be created between setjmp() and a call that may
/// fail.
class Encoder {
 public:
  explicit Encoder(const std::string& where) : where_(where) {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, &on_error, [](png_structp, png_const_charp) {});
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, this, &on_write, [](png_structp) {});
  }
  ~Encoder() { png_destroy_write_struct(&png_, &info_); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  std::vector<std::byte> encode(const PngFormat& format, const unsigned char* samples, const PngOptions& options) {
    if (!write(format, samples, options)) throw Error(where_, std::string("cannot be encoded as png: ") + reason_);
    return std::move(file_);
  }

 private:
  [[noreturn]] static void on_error(png_structp png, png_const_charp text) {
    Encoder& encoder = *static_cast<Encoder*>(png_get_error_ptr(png));
    std::strncpy(encoder.reason_, text, sizeof encoder.reason_ - 1);
    std::longjmp(encoder.back_, 1);
  }
  static void on_write(png_structp png, png_bytep from, std::size_t count) {
    Encoder& encoder = *static_cast<Encoder*>(png_get_io_ptr(png));
    const auto* bytes = reinterpret_cast<const std::byte*>(from);
    encoder.file_.insert(encoder.file_.end(), bytes, bytes + count);
  }

  bool write(const PngFormat& format, const unsigned char* samples, const PngOptions& options) {
    if (setjmp(back_) != 0) return false;
    png_set_compression_level(png_, options.level);
    png_set_compression_strategy(png_, zlib_strategy(options.strategy));
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, libpng_bits(options.filter));
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(format.width), static_cast<png_uint_32>(format.height), format.bits,
                 format.color_type(), PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!options.profile.empty())
      png_set_iCCP(png_, info_, "ICC profile", PNG_COMPRESSION_TYPE_BASE,
                   reinterpret_cast<png_const_bytep>(options.profile.data()), static_cast<png_uint_32>(options.profile.size()));
    else if (format.channels > 1)
      png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_ABSOLUTE);
    if (options.dots_per_inch > 0.0) {
      const auto per_metre = static_cast<png_uint_32>(options.dots_per_inch / 0.0254 + 0.5);
      png_set_pHYs(png_, info_, per_metre, per_metre, PNG_RESOLUTION_METER);
    }
    png_write_info(png_, info_);
    if (format.bits == 16) png_set_swap(png_);
    const std::size_t row =
        static_cast<std::size_t>(format.width) * static_cast<std::size_t>(format.channels * format.bits / 8);
    for (int y = 0; y < format.height; ++y) png_write_row(png_, samples + row * static_cast<std::size_t>(y));
    png_write_end(png_, info_);
    return true;
  }

  const std::string& where_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::vector<std::byte> file_;
  char reason_[200] = {};
  std::jmp_buf back_;
};

template <class AnyImage>
std::vector<std::byte> encode(const std::string& where, const AnyImage& image, const PngOptions& options) {
  using Code = typename decltype(image.rgb)::value_type;
  assert(image.rgb.size() == std::size_t{3} * image.width * image.height);
  const bool alpha = !image.alpha.empty();
  check_image_size(where, image.width, image.height, alpha ? 4 : 3);
  const std::vector<Code> with_alpha = interleaved(image.rgb, image.alpha);
  const std::vector<Code>& samples = alpha ? with_alpha : image.rgb;
  return Encoder(where).encode({image.width, image.height, 8 * sizeof(Code), alpha ? 4 : 3},
                               reinterpret_cast<const unsigned char*>(samples.data()), options);
}

}  // namespace

std::vector<std::byte> encode_png(const Image8& image, const PngOptions& options) { return encode("PNG", image, options); }

void write_png(const std::filesystem::path& path, const Image8& image, const PngOptions& options) {
  write_file_atomically(path, encode(path.string(), image, options));
}

void write_png(const std::filesystem::path& path, const Image16& image, const PngOptions& options) {
  write_file_atomically(path, encode(path.string(), image, options));
}

void write_png(const std::filesystem::path& path, const HeightMap& heights, const PngOptions& options) {
  assert(heights.codes.size() == static_cast<std::size_t>(heights.width) * heights.height);
  const std::string where = path.string();
  check_image_size(where, heights.width, heights.height, 1);
  const auto* samples = reinterpret_cast<const unsigned char*>(heights.codes.data());
  write_file_atomically(path, Encoder(where).encode({heights.width, heights.height, 16, 1}, samples, options));
}

}  // namespace lippmann
