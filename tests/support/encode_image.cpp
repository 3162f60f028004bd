#include "support/encode_image.hpp"

#include <cstdio>
#include <cstdlib>
// clang-format off: jpeglib.h needs FILE from the header before it
#include <jpeglib.h>
// clang-format on
#include <png.h>
#include <webp/encode.h>

namespace lippmann::test {

std::vector<unsigned char> encode_png(int width, int height, int channels, const std::vector<std::uint8_t>& samples) {
  constexpr png_uint_32 kFormats[] = {0, PNG_FORMAT_GRAY, PNG_FORMAT_GA, PNG_FORMAT_RGB, PNG_FORMAT_RGBA};
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width), image.height = static_cast<png_uint_32>(height);
  image.format = kFormats[channels];
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<unsigned char> file(size);
  if (!png_image_write_to_memory(&image, file.data(), &size, 0, samples.data(), 0, nullptr)) std::abort();
  file.resize(size);
  return file;
}

std::vector<unsigned char> encode_jpeg(int width, int height, int channels, const std::vector<std::uint8_t>& samples,
                                       bool progressive) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width), jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = channels;
  jpeg.in_color_space = channels == 1 ? JCS_GRAYSCALE : channels == 3 ? JCS_RGB : JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 95, TRUE);
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<std::uint8_t> copy = samples;
  for (int y = 0; y < height; ++y) {
    unsigned char* row = copy.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width * channels);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::vector<unsigned char> file(bytes, bytes + size);
  std::free(bytes);
  jpeg_destroy_compress(&jpeg);
  return file;
}

std::vector<unsigned char> encode_webp(int width, int height, const std::vector<std::uint8_t>& samples) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(samples.data(), width, height, 4 * width, &bytes);
  std::vector<unsigned char> file(bytes, bytes + size);
  WebPFree(bytes);
  return file;
}

}  // namespace lippmann::test
