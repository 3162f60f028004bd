// The readers of pictures must throw Error, or return as many samples as the header states.
//
// fuzz_picture_seeds SEEDS && fuzz_picture -dict=fuzz/picture.dict CORPUS SEEDS; or scripts/fuzz picture.
#include <cstdlib>
#include <iostream>
#include <span>
#include <variant>

#include "image/decode.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace lippmann;
  const FileBytes file = std::as_bytes(std::span(data, size));
  if (is_heic(file)) return 0;  // libheif has its own fuzzers
  try {
    const DecodedPicture picture = decode_picture(file, "picture");
    const PictureHeader& header = picture.header;
    const std::size_t expected =
        static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height) * header.channels.size();
    const std::size_t found = std::visit([](const auto& samples) { return samples.size(); }, picture.samples);
    if (found == expected) return 0;
    std::cerr << found << " samples instead of " << expected << '\n';
    std::abort();
  } catch (const Error&) {
    return 0;
  }
}
