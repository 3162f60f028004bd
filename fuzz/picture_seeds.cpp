// Writes seeds for fuzz_picture to a folder: a small picture in each format.
#include <webp/encode.h>

#include <filesystem>
#include <fstream>

#include "image/exr.hpp"
#include "image/netpbm.hpp"
#include "image/png.hpp"
#include "image/tiff.hpp"
#include "support/encode_image.hpp"
#include "support/exr_file.hpp"
#include "support/pictures.hpp"

namespace {

using namespace lippmann;

constexpr int kWidth = 12, kHeight = 9;

template <class Bytes>
void write(const std::filesystem::path& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(std::data(bytes)), static_cast<std::streamsize>(std::size(bytes)));
}

void write_webp(const std::filesystem::path& path, const Image8& codes) {
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeRGB(codes.rgb.data(), kWidth, kHeight, 3 * kWidth, 80.0f, &encoded);
  write(path, std::span(encoded, size));
  WebPFree(encoded);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const Image8 codes = test::smooth_codes(kWidth, kHeight);
  const Image film = test::noise_image(kWidth, kHeight, 3);
  write(folder / "png", encode_png(codes));
  write(folder / "jpeg", test::encode_jpeg(kWidth, kHeight, 3, codes.rgb));
  write(folder / "jpeg_progressive", test::encode_jpeg(kWidth, kHeight, 3, codes.rgb, true));
  write_tiff(folder / "tiff", codes);
  const ExrLayer layers[] = {film_layer(film)};
  for (const ExrCompression compression :
       {ExrCompression::kNone, ExrCompression::kRunLength, ExrCompression::kZip, ExrCompression::kPiz})
    write_exr(folder / ("exr_" + std::to_string(static_cast<int>(compression))), layers, compression);
  write_webp(folder / "webp", codes);
  write(folder / "pfm", encode_pfm(film));
  write(folder / "ppm", encode_ppm({{kWidth, kHeight, {codes.rgb.begin(), codes.rgb.end()}}, 255}));
  const char hdr_row[] = {2, 2, 0, 8, '\x88', '\x40', 3, 1, 2, 3, '\x85', 9, '\x88', 0, '\x84', '\x81', '\x84', '\x80'};
  write(folder / "hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n" + std::string(hdr_row, sizeof hdr_row));
  write(folder / "hdr_plain", std::string("#?RGBE\nEXPOSURE=2\nFORMAT=32-bit_rle_xyze\n\n+X 1 -Y 2\nabc\x80\1\1\1\1"));
  const test::ExrPart part{{1, 0, 2, 1}, {0, 0, 1, 1}, {{"b", {1, 2, 3, 4}}, {"g", {1, 2, 3, 4}}, {"r", {1, 2, 3, 4}}}};
  write(folder / "exr_windows", test::exr_file(part));
  const char bmp[] = {'B', 'M', 58, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 24, 0};
  write(folder / "bmp", std::string(bmp, sizeof bmp) + std::string(28, '\0'));
  const char gif[] =
      "GIF89a\2\0\2\0\x81\0\0\x0a\x14\x1e\x28\x32\x3c\x46\x50\x5a\x64\x6e\x78!\xf9\4\1\0\0\1\0,"
      "\0\0\0\0\2\0\2\0\0\2\3\x44\x34\5\0;";
  write(folder / "gif", std::string(gif, sizeof gif - 1));
  const char tga[] = {0, 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 1, 0, 8, 0, '\x82', 50, 0, 60};
  write(folder / "tga", std::string(tga, sizeof tga));
  return 0;
}
