#include "image/oiio.hpp"

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <span>

#include "core/error.hpp"

namespace lippmann {

void check_image_size(const std::string& where, std::int64_t width, std::int64_t height, std::int64_t channels) {
  const bool sides = width >= 1 && height >= 1 && channels >= 1 && width <= kMaxImageSide && height <= kMaxImageSide;
  if (sides && width * height <= kMaxImagePixels && channels <= kMaxImageSamples / (width * height)) return;
  throw Error(where, fmt::format("a picture of {} x {} pixels with {} channels", width, height, channels),
              fmt::format("sides of 1 to {} pixels, at most {} pixels and {} samples", kMaxImageSide, kMaxImagePixels,
                          kMaxImageSamples));
}

void keep_oiio_single_threaded() {
  static std::once_flag once;
  std::call_once(once, [] {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
  });
}

std::vector<std::byte> encode_with_oiio(const std::string& where, const std::string& format, const OIIO::ImageSpec& spec,
                                        OIIO::TypeDesc sample_type, const void* samples) {
  check_image_size(where, spec.width, spec.height, spec.nchannels);
  keep_oiio_single_threaded();
  const auto failure = [&](const std::string& reason) {
    return Error(where, "cannot be encoded as " + format + ": " + reason);
  };
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  if (!output) throw failure(OIIO::geterror());
  OIIO::Filesystem::IOVecOutput memory;
  if (!output->set_ioproxy(&memory)) throw failure("OpenImageIO cannot write it to memory");
  if (!output->open("memory." + format, spec) || !output->write_image(sample_type, samples) || !output->close())
    throw failure(output->geterror());
  const std::span<const std::byte> bytes = std::as_bytes(std::span(memory.buffer()));
  return {bytes.begin(), bytes.end()};
}

}  // namespace lippmann
