#include "image/tiff.hpp"

#include <cassert>
#include <memory>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "image/oiio.hpp"

namespace lippmann {
namespace {

constexpr double kMmPerInch = 25.4;

OIIO::ImageSpec spec_of(const Image8& image, double pixels_per_mm) {
  OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("compression", "zip");
  spec.attribute("tiff:zipquality", 1);
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // else the time of writing: equal pictures would differ
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

}  // namespace

void write_tiff(const std::filesystem::path& path, const Image8& image, double pixels_per_mm) {
  assert(image.rgb.size() == std::size_t{3} * image.width * image.height);
  check_image_size(path.string(), image.width, image.height, 3);
  keep_oiio_single_threaded();
  AtomicFile file(path);
  const std::string temporary = file.temporary_path().string();
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("tiff");
  const auto failure = [&](const std::string& reason) { return Error(path.string(), "cannot be written as TIFF: " + reason); };
  if (!output) throw failure(OIIO::geterror());
  if (!output->open(temporary, spec_of(image, pixels_per_mm)) || !output->write_image(OIIO::TypeUInt8, image.rgb.data()) ||
      !output->close())
    throw failure(output->geterror());
  if (!can_be_opened(temporary)) throw failure("the disk may be full");
  file.commit();
}

}  // namespace lippmann
