#include "image/print_file.hpp"

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/recorded_file.hpp"
#include "image/icc_transform.hpp"
#include "image/png.hpp"
#include "image/tiff.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kMaxProfileBytes = std::size_t{64} << 20;  // large profiles of printing presses have about 10 MB
constexpr double kMmPerInch = 25.4;

bool is_tiff_name(const std::filesystem::path& path) { return path.extension() == ".tif" || path.extension() == ".tiff"; }

template <class Code>
std::vector<Code> codes_for_profile(const std::vector<Code>& rgb, const OutputProfile& profile) {
  std::optional<Samples> codes = output_codes(profile.bytes(), Samples(rgb));
  if (!codes) throw Error(profile.where(), "its tables are damaged: colours cannot be converted to it");
  return std::get<std::vector<Code>>(*std::move(codes));
}

template <class AnyImage>
void write_codes(const std::filesystem::path& path, const AnyImage& image, double dots_per_inch, const OutputProfile* profile) {
  using Code = typename decltype(image.rgb)::value_type;
  const TiffOptions tiff{.pixels_per_mm = dots_per_inch / kMmPerInch,
                         .profile = profile ? std::span(profile->bytes()) : std::span<const std::byte>()};
  if (profile && profile->has_inks())
    return write_tiff(path, Inks<Code>{image.width, image.height, codes_for_profile(image.rgb, *profile)}, tiff);
  AnyImage own;
  if (profile) own = {image.width, image.height, codes_for_profile(image.rgb, *profile)};
  const AnyImage& shown = profile ? own : image;
  if (is_tiff_name(path)) return write_tiff(path, shown, tiff);
  check_picture_ending(path, shown);
  PngOptions png;
  png.dots_per_inch = dots_per_inch, png.profile = tiff.profile;
  write_png(path, shown, png);
}

}  // namespace

OutputProfile::OutputProfile(const std::filesystem::path& file)
    : where_(file.string()), bytes_(read_recorded_bytes(file, kMaxProfileBytes, "a colour profile")) {
#if !LIPPMANN_HAS_LCMS
  throw Error(where_, "colours cannot be converted to a profile: this program is built without Little CMS",
              "a build with Little CMS, or no `icc`");
#endif
  const std::optional<int> channels = output_channels(bytes_);
  if (!channels) throw Error(where_, "is not an ICC output profile", "the RGB or CMYK profile of a printer or a paper (.icc)");
  has_inks_ = *channels == 4;
}

void write_print(const std::filesystem::path& path, const Picture& picture, double dots_per_inch,
                 const OutputProfile* profile) {
  if (profile && profile->has_inks() && !is_tiff_name(path))
    throw Error(path.string(), "only TIFF files can store the inks of " + profile->where(), "a name that ends in .tiff");
  std::visit(
      [&](const auto& image) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(image)>, Image>) {
          if (profile)
            throw Error(profile->where(), "float samples, as in EXR files, cannot be converted to a profile",
                        "pictures of 8 or 16 bits");
          write_picture(path, picture);
        } else {
          write_codes(path, image, dots_per_inch, profile);
        }
      },
      picture);
}

}  // namespace lippmann
