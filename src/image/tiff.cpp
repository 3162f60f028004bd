#include "image/tiff.hpp"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cassert>
#include <cstdarg>
#include <memory>
#include <system_error>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/platform.hpp"
#include "image/limits.hpp"
#include "image/rgba.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr double kMmPerInch = 25.4;

constexpr std::size_t kMaxClassicSamples = (std::size_t{7} << 32) / 8;

/// Records the first failed write, because libtiff does not report failures while it writes the directory at the end of the
/// file.
class Output {
 public:
  Output(const std::filesystem::path& temporary, const std::filesystem::path& path, bool big)
      : path_(path), file_(temporary, platform::OpenFile::Mode::kCreate, problem_) {
    if (problem_) throw failure();
    const std::unique_ptr<TIFFOpenOptions, OptionsDeleter> options(TIFFOpenOptionsAlloc());
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &be_silent, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), &be_silent, nullptr);
    tiff_ = TIFFClientOpenExt("file", big ? "w8" : "w", this, &on_read, &on_write, &on_seek, &on_close, &on_size, &on_map,
                              &on_unmap, options.get());
    if (!tiff_) throw failure();
  }
  ~Output() {
    if (tiff_) TIFFClose(tiff_);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  TIFF* tiff() { return tiff_; }

  void finish() {
    if (!TIFFWriteDirectory(tiff_)) throw failure();
    TIFFClose(std::exchange(tiff_, nullptr));
    keep(file_.close());
    if (problem_) throw failure();
  }

  Error failure() const {
    return Error(path_.string(), "cannot be written as TIFF: " + (problem_ ? problem_.message() : "libtiff failed"));
  }

 private:
  struct OptionsDeleter {
    void operator()(TIFFOpenOptions* p) const { TIFFOpenOptionsFree(p); }
  };

  static int be_silent(TIFF*, void*, const char*, const char*, va_list) { return 1; }
  static Output& of(thandle_t handle) { return *static_cast<Output*>(handle); }
  static tmsize_t on_read(thandle_t handle, void* to, tmsize_t count) {
    std::error_code problem;
    const std::size_t done = of(handle).file_.read(to, static_cast<std::size_t>(count), problem);
    return problem ? -1 : static_cast<tmsize_t>(done);
  }
  static tmsize_t on_write(thandle_t handle, void* from, tmsize_t count) {
    const std::error_code problem = of(handle).file_.write(from, static_cast<std::size_t>(count));
    of(handle).keep(problem);
    return problem ? -1 : count;
  }
  static toff_t on_seek(thandle_t handle, toff_t offset, int whence) {
    return static_cast<toff_t>(of(handle).file_.seek(static_cast<std::int64_t>(offset), whence));
  }
  static int on_close(thandle_t) { return 0; }
  static toff_t on_size(thandle_t handle) {
    std::uintmax_t bytes = 0;
    std::error_code ignored;
    of(handle).file_.kind(bytes, ignored);
    return bytes;
  }
  static int on_map(thandle_t, void**, toff_t*) { return 0; }
  static void on_unmap(thandle_t, void*, toff_t) {}

  void keep(const std::error_code& problem) {
    if (!problem_) problem_ = problem;
  }

  const std::filesystem::path& path_;
  std::error_code problem_;
  platform::OpenFile file_;
  TIFF* tiff_ = nullptr;
};

/// Writes an Exif directory that states sRGB, and starts a new directory for the image. Returns the offset of the Exif
/// directory, or 0 on failure.
std::uint64_t write_colour_space(TIFF* tiff) {
  constexpr std::uint16_t kSrgb = 1;
  std::uint64_t place = 0;
  const bool written = TIFFCreateEXIFDirectory(tiff) == 0 && TIFFSetField(tiff, EXIFTAG_COLORSPACE, kSrgb) &&
                       TIFFWriteCustomDirectory(tiff, &place);
  TIFFFreeDirectory(tiff);  // otherwise TIFFCreateDirectory() would leak the Exif directory
  if (TIFFCreateDirectory(tiff) != 0) return 0;
  return written ? place : 0;
}

constexpr std::uint32_t kRowsPerStrip = 32;

template <class Code>
struct Raster {
  int width, height;
  std::size_t colors;  ///< 3: RGB; 4: CMYK
  const std::vector<Code>& codes;
  const std::vector<Code>& alpha;
};

template <class Code>
void set_fields(TIFF* tiff, const Raster<Code>& image, const TiffOptions& options) {
  const bool alpha = !image.alpha.empty(), has_inks = image.colors == 4;
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.height));
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, static_cast<int>(image.colors) + (alpha ? 1 : 0));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, static_cast<int>(8 * sizeof(Code)));
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, has_inks ? PHOTOMETRIC_SEPARATED : PHOTOMETRIC_RGB);
  if (has_inks) TIFFSetField(tiff, TIFFTAG_INKSET, INKSET_CMYK);
  if (!options.profile.empty())
    TIFFSetField(tiff, TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(options.profile.size()), options.profile.data());
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, kRowsPerStrip);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  TIFFSetField(tiff, TIFFTAG_ZIPQUALITY, 1);
  TIFFSetField(tiff, TIFFTAG_DATETIME, "1970:01:01 00:00:00");  // a fixed date gives equal bytes for equal images
  if (alpha) {
    const std::uint16_t unassociated = EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &unassociated);
  }
  if (options.pixels_per_mm > 0.0) {
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, options.pixels_per_mm * kMmPerInch);
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, options.pixels_per_mm * kMmPerInch);
    TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  }
}

template <class Code>
std::vector<Code> strip_of(const Raster<Code>& image, std::size_t first_row, std::size_t rows) {
  const std::size_t width = static_cast<std::size_t>(image.width), begin = first_row * width, end = begin + rows * width;
  const auto part = [&](const std::vector<Code>& codes, std::size_t channels) {
    return std::vector<Code>(codes.begin() + static_cast<std::ptrdiff_t>(channels * begin),
                             codes.begin() + static_cast<std::ptrdiff_t>(channels * end));
  };
  std::vector<Code> colors = part(image.codes, image.colors);
  return image.alpha.empty() ? colors : interleaved(colors, part(image.alpha, 1));
}

void check_tiff_size(const std::string& where, int width, int height) {
  const bool sides = width >= 1 && height >= 1 && std::max(width, height) <= kMaxImageSide;
  if (sides && std::int64_t{width} * height <= kMaxTiffPixels) return;
  throw Error(where, fmt::format("a picture of {} x {} pixels is empty or too large", width, height),
              fmt::format("sides of 1 to {} pixels, at most {} pixels", kMaxImageSide, kMaxTiffPixels));
}

template <class Code>
void write(const std::filesystem::path& path, const Raster<Code>& image, const TiffOptions& options) {
  assert(image.codes.size() == image.colors * image.width * image.height);
  check_tiff_size(path.string(), image.width, image.height);
  AtomicFile file(path);
  const std::size_t bytes = (image.codes.size() + image.alpha.size()) * sizeof(Code);
  Output output(file.temporary_path(), path, options.kind == TiffKind::kBig || bytes > kMaxClassicSamples);
  const bool is_srgb = options.profile.empty();
  const std::uint64_t colour_space = is_srgb ? write_colour_space(output.tiff()) : 0;
  if (is_srgb && colour_space == 0) throw output.failure();
  set_fields(output.tiff(), image, options);
  if (is_srgb) TIFFSetField(output.tiff(), TIFFTAG_EXIFIFD, colour_space);
  const auto height = static_cast<std::size_t>(image.height);
  for (std::size_t row = 0; row < height; row += kRowsPerStrip) {
    std::vector<Code> strip = strip_of(image, row, std::min<std::size_t>(kRowsPerStrip, height - row));
    const auto number = static_cast<std::uint32_t>(row / kRowsPerStrip);
    if (TIFFWriteEncodedStrip(output.tiff(), number, strip.data(), static_cast<tmsize_t>(sizeof(Code) * strip.size())) < 0)
      throw output.failure();
  }
  output.finish();
  file.commit();
}

template <class AnyImage>
void write_rgb(const std::filesystem::path& path, const AnyImage& image, const TiffOptions& options) {
  write(path, Raster<typename decltype(image.rgb)::value_type>{image.width, image.height, 3, image.rgb, image.alpha}, options);
}

template <class Code>
void write_inks(const std::filesystem::path& path, const Inks<Code>& image, const TiffOptions& options) {
  assert(!options.profile.empty());
  const std::vector<Code> opaque;
  write(path, Raster<Code>{image.width, image.height, 4, image.cmyk, opaque}, options);
}

}  // namespace

void write_tiff(const std::filesystem::path& path, const Image8& image, const TiffOptions& options) {
  write_rgb(path, image, options);
}

void write_tiff(const std::filesystem::path& path, const Image16& image, const TiffOptions& options) {
  write_rgb(path, image, options);
}

void write_tiff(const std::filesystem::path& path, const Inks<std::uint8_t>& image, const TiffOptions& options) {
  write_inks(path, image, options);
}

void write_tiff(const std::filesystem::path& path, const Inks<std::uint16_t>& image, const TiffOptions& options) {
  write_inks(path, image, options);
}

}  // namespace lippmann
