#include "bench/light_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "lippmann/image/picture_file.hpp"

namespace lippmann::bench {
namespace {

unsigned char amplified(double difference) {
  return static_cast<unsigned char>(std::clamp(kMidGrey + std::lround(kErrorGain * difference), 0L, 255L));
}

}  // namespace

Image8 error_picture(const Image8& reference, const Image8& test) {
  Image8 error{reference.width, reference.height, {}};
  error.rgb.reserve(reference.rgb.size());
  for (std::size_t i = 0; i < reference.rgb.size(); ++i)
    error.rgb.push_back(amplified(static_cast<double>(test.rgb[i]) - reference.rgb[i]));
  return error;
}

Image8 block_error_picture(const Image8& reference, const Image8& test, const std::vector<Block>& blocks) {
  Image8 error{reference.width, reference.height, std::vector<unsigned char>(reference.rgb.size(), kMidGrey)};
  const std::vector<double> wanted = block_means(reference, blocks), made = block_means(test, blocks);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t c = 0; c < 3; ++c) {
      const unsigned char code = amplified(made[3 * b + c] - wanted[3 * b + c]);
      for (const std::uint32_t pixel : blocks[b]) error.rgb[3 * pixel + c] = code;
    }
  return error;
}

void write_light_pictures(const std::filesystem::path& folder, const std::string& name, const Image8& reference,
                          const Image8& full, const Image8& reuse, const std::vector<Block>& blocks) {
  std::error_code ignored;  // the writing below says what is wrong
  std::filesystem::create_directories(folder, ignored);
  const auto write = [&](const char* what, const Image8& picture) {
    write_picture(folder / (name + "_" + what + ".png"), picture);
  };
  write("reference", reference);
  write("full", full);
  write("reuse", reuse);
  write("error", error_picture(reference, reuse));
  write("block_error", block_error_picture(reference, reuse, blocks));
}

}  // namespace lippmann::bench
