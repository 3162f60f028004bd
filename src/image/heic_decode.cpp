// Decodes the main image and the depth image of HEIC and AVIF files with libheif (image/heic_module.hpp).
#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

#include "core/loaded_module.hpp"
#include "image/color_profile.hpp"
#include "image/decode.hpp"
#include "image/heic_module.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

constexpr ModuleName kHeicModule{"liblippmann_heic.so", "lippmann_heic_module", "HEIC pictures", "lippmann-heic"};

const HeicModule& heic_module() {
  static const auto& loaded = *static_cast<const HeicModule*>(load_module(kHeicModule, kHeicModuleVersion));
  return loaded;
}

PictureHeader header_of(const HeicPicture& picture, const std::string& where) {
  if (!picture.problem.empty()) throw unreadable_picture(where, picture.problem);
  const int channels = picture.has_alpha ? 4 : 3;
  check_image_size(where, picture.width, picture.height, channels);
  PictureHeader header =
      plain_header(picture.width, picture.height, channels, picture.bits > 8 ? SampleKind::kWord : SampleKind::kByte);
  header.profile = profile_to_apply(picture.profile);
  return header;
}

}  // namespace

bool is_heic(FileBytes file) {
  constexpr std::array<std::string_view, 7> kBrands{"heic", "heix", "heim", "heis", "mif1", "avif", "MiHE"};
  if (file.size() < 12 || std::memcmp(file.data() + 4, "ftyp", 4) != 0) return false;
  const std::string_view brand(reinterpret_cast<const char*>(file.data()) + 8, 4);
  return std::find(kBrands.begin(), kBrands.end(), brand) != kBrands.end();
}

PictureHeader heic_header(FileBytes file, const std::string& where) { return header_of(heic_module().header(file), where); }

DecodedPicture decode_heic(FileBytes file, const std::string& where) {
  heic_header(file, where);  // throws for impossible sizes before memory is allocated
  HeicPicture picture = heic_module().decode(file);
  const PictureHeader header = header_of(picture, where);
  if (header.kind == SampleKind::kByte) return {header, std::vector<std::uint8_t>(picture.codes.begin(), picture.codes.end())};
  const std::uint32_t most = (1u << picture.bits) - 1;
  for (std::uint16_t& code : picture.codes) code = static_cast<std::uint16_t>((code * 65535u + most / 2) / most);
  return {header, std::move(picture.codes)};
}

std::optional<StoredDepth> decode_heic_depth(FileBytes file, const std::string& where) {
  const auto [image, is_z] = heic_module().depth(file);
  if (!image.problem.empty()) throw unreadable_picture(where, image.problem);
  if (image.codes.empty()) return std::nullopt;
  StoredDepth stored{Image(image.width, image.height, 1), is_z};
  const float most = static_cast<float>((1u << image.bits) - 1);
  const std::size_t channels = image.has_alpha ? 4 : 3;
  for (std::size_t i = 0; i < stored.grey.data.size(); ++i)
    stored.grey.data[i] = static_cast<float>(image.codes[i * channels]) / most;
  return stored;
}

}  // namespace lippmann
