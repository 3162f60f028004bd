// Decodes PPM, PGM and PFM (netpbm.hpp) as images.
#include <algorithm>
#include <utility>

#include "image/decode.hpp"
#include "image/netpbm.hpp"

namespace lippmann {
namespace {

bool has_letter(FileBytes file, std::size_t at, const char* letters) {
  return file.size() > at && std::string_view(letters).find(std::to_integer<char>(file[at])) != std::string_view::npos;
}

bool is_pfm(FileBytes file) { return has_letter(file, 1, "fF"); }

template <class Code>
std::vector<Code> scaled(const PpmCodes& picture, unsigned max, std::size_t step) {
  const auto highest = static_cast<unsigned>(picture.highest);
  std::vector<Code> codes;
  codes.reserve(picture.codes.rgb.size() / step);
  for (std::size_t i = 0; i < picture.codes.rgb.size(); i += step)
    codes.push_back(static_cast<Code>((picture.codes.rgb[i] * max + highest / 2) / highest));
  return codes;
}

}  // namespace

bool is_netpbm(FileBytes file) {
  return has_letter(file, 0, "P") && has_letter(file, 1, "56fF") && has_letter(file, 2, " \t\r\n#");
}

PictureHeader netpbm_header(FileBytes file, const std::string& where) { return decode_netpbm(file, where).header; }

DecodedPicture decode_netpbm(FileBytes file, const std::string& where) {
  if (is_pfm(file)) {
    Image image = parse_pfm(file, where);
    return {plain_header(image.width, image.height, image.channels, SampleKind::kFloat), std::move(image.data)};
  }
  const PpmCodes picture = parse_ppm(file, where);
  const bool grey = has_letter(file, 1, "5"), wide = picture.highest > 255;
  PictureHeader header =
      plain_header(picture.codes.width, picture.codes.height, grey ? 1 : 3, wide ? SampleKind::kWord : SampleKind::kByte);
  const std::size_t step = grey ? 3 : 1;
  if (wide) return {std::move(header), scaled<std::uint16_t>(picture, 65535, step)};
  return {std::move(header), scaled<std::uint8_t>(picture, 255, step)};
}

}  // namespace lippmann
