#include "image/tiff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <memory>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "image/rgba.hpp"

namespace lippmann {
namespace {

constexpr double kMmPerInch = 25.4;

constexpr std::size_t kMaxClassicSamples = (std::size_t{7} << 32) / 8;

OIIO::ImageSpec spec_of(const Image8& image, double pixels_per_mm, TiffKind kind) {
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("compression", "zip");
  spec.attribute("tiff:zipquality", 1);
  spec.attribute("tiff:bigtiff", kind == TiffKind::kBig || image.rgb.size() + image.alpha.size() > kMaxClassicSamples ? 1 : 0);
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // else the time of writing: equal pictures would differ
  if (!image.alpha.empty()) add_alpha(spec);
  if (pixels_per_mm > 0.0) {
    const auto dots_per_inch = static_cast<float>(pixels_per_mm * kMmPerInch);
    spec.attribute("XResolution", dots_per_inch);
    spec.attribute("YResolution", dots_per_inch);
    spec.attribute("ResolutionUnit", "in");
  }
  return spec;
}

/// libtiff does not say whether it could write the last bytes: the directory, without which nothing can be opened.
bool can_be_opened(const std::filesystem::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
  return input != nullptr;
}

void check_tiff_size(const std::string& where, const Image8& image) {
  const bool sides = image.width >= 1 && image.height >= 1 && std::max(image.width, image.height) <= kMaxImageSide;
  if (sides && std::int64_t{image.width} * image.height <= kMaxTiffPixels) return;
  throw Error(where, fmt::format("a picture of {} x {} pixels", image.width, image.height),
              fmt::format("sides of 1 to {} pixels, at most {} pixels", kMaxImageSide, kMaxTiffPixels));
}

}  // namespace

void write_tiff(const std::filesystem::path& path, const Image8& image, double pixels_per_mm, TiffKind kind) {
  assert(image.rgb.size() == std::size_t{3} * image.width * image.height);
  check_tiff_size(path.string(), image);
  keep_oiio_single_threaded();
  const std::vector<unsigned char> with_alpha = interleaved(image.rgb, image.alpha);
  const std::vector<unsigned char>& samples = image.alpha.empty() ? image.rgb : with_alpha;
  AtomicFile file(path);
  const std::string temporary = file.temporary_path().string();
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("tiff");
  const auto failure = [&](const std::string& reason) { return Error(path.string(), "cannot be written as TIFF: " + reason); };
  if (!output) throw failure(OIIO::geterror());
  if (!output->open(temporary, spec_of(image, pixels_per_mm, kind)) || !output->write_image(OIIO::TypeUInt8, samples.data()) ||
      !output->close())
    throw failure(output->geterror());
  if (!can_be_opened(temporary)) throw failure("the disk may be full");
  file.commit();
}

}  // namespace lippmann
