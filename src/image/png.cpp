#include "image/png.hpp"

#include <cassert>
#include <string>

#include "core/atomic_file.hpp"
#include "image/rgba.hpp"

namespace lippmann {
namespace {

const char* oiio_name(PngStrategy strategy) {
  switch (strategy) {
    case PngStrategy::kDefault:
      return "default";
    case PngStrategy::kFiltered:
      return "filtered";
    case PngStrategy::kRunLength:
      return "rle";
    case PngStrategy::kHuffman:
      return "huffman";
  }
  return "default";
}

/// libpng's PNG_FILTER_ bits.
int libpng_bits(PngFilter filter) {
  switch (filter) {
    case PngFilter::kNone:
      return 0x08;
    case PngFilter::kLeft:
      return 0x10;
    case PngFilter::kUp:
      return 0x20;
    case PngFilter::kAverage:
      return 0x40;
    case PngFilter::kPaeth:
      return 0x80;
    case PngFilter::kAdaptive:
      return 0xf8;
  }
  return 0x08;
}

template <class AnyImage>
std::vector<std::byte> encode(const std::string& where, const AnyImage& image, OIIO::TypeDesc type, const PngOptions& options) {
  assert(image.rgb.size() == std::size_t{3} * image.width * image.height);
  OIIO::ImageSpec spec(image.width, image.height, 3, type);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", options.level);
  spec.attribute("compression", oiio_name(options.strategy));
  spec.attribute("png:filter", libpng_bits(options.filter));
  if (image.alpha.empty()) return encode_with_oiio(where, "png", spec, type, image.rgb.data());
  add_alpha(spec);
  return encode_with_oiio(where, "png", spec, type, interleaved(image.rgb, image.alpha).data());
}

}  // namespace

std::vector<std::byte> encode_png(const Image8& image, const PngOptions& options) {
  return encode("PNG", image, OIIO::TypeUInt8, options);
}

std::vector<std::byte> encode_png(const Image16& image, const PngOptions& options) {
  return encode("PNG", image, OIIO::TypeUInt16, options);
}

void write_png(const std::filesystem::path& path, const Image8& image, const PngOptions& options) {
  write_file_atomically(path, encode(path.string(), image, OIIO::TypeUInt8, options));
}

void write_png(const std::filesystem::path& path, const Image16& image, const PngOptions& options) {
  write_file_atomically(path, encode(path.string(), image, OIIO::TypeUInt16, options));
}

}  // namespace lippmann
