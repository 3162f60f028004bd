#include "image/read_image.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "image/decode.hpp"
#include "image/file_bytes.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct Format {
  bool (*begins)(FileBytes);
  PictureHeader (*header)(FileBytes, const std::string&);
  DecodedPicture (*decode)(FileBytes, const std::string&);
};

/// TGA last: it has no mark.
constexpr std::array kFormats{Format{is_png, png_header, decode_png},          Format{is_exr, exr_header, decode_exr},
                              Format{is_jpeg, jpeg_header, decode_jpeg},       Format{is_tiff, tiff_header, decode_tiff},
                              Format{is_hdr, hdr_header, decode_hdr},          Format{is_webp, webp_header, decode_webp},
                              Format{is_netpbm, netpbm_header, decode_netpbm}, Format{is_tga, tga_header, decode_tga}};

const Format& format_of(FileBytes file, const std::string& where) {
  for (const Format& format : kFormats)
    if (format.begins(file)) return format;
  throw Error(where, "cannot be read as a picture: it begins as none",
              "PNG, JPEG, TIFF, OpenEXR, Radiance HDR, WebP, PPM, PGM, PFM or TGA");
}

PictureHeader read_header(const fs::path& path) { return picture_header(read_file_bytes(path), path.string()); }

DecodedPicture read_decoded(const fs::path& path) { return decode_picture(read_file_bytes(path), path.string()); }

std::vector<unsigned char> first_three(const std::vector<unsigned char>& codes, std::size_t channels) {
  const std::size_t pixels = codes.size() / channels;
  const std::size_t step = channels >= 3 ? 1 : 0;
  std::vector<unsigned char> rgb(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) rgb[3 * i + c] = codes[i * channels + c * step];
  return rgb;
}

template <class Code>
std::vector<float> shares_of(const std::vector<Code>& codes, float maximum) {
  std::vector<float> values(codes.size());
  std::transform(codes.begin(), codes.end(), values.begin(), [=](Code code) { return static_cast<float>(code) / maximum; });
  return values;
}

Image to_image(DecodedPicture picture) {
  Image image;
  image.width = picture.header.width, image.height = picture.header.height;
  image.channels = static_cast<int>(picture.header.channels.size());
  if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&picture.samples))
    image.data = shares_of(*bytes, 255.0f);
  else if (const auto* words = std::get_if<std::vector<std::uint16_t>>(&picture.samples))
    image.data = shares_of(*words, 65535.0f);
  else
    image.data = std::get<std::vector<float>>(std::move(picture.samples));
  return image;
}

Image8 to_image8(DecodedPicture picture) {
  const int width = picture.header.width, height = picture.header.height;
  const std::size_t channels = picture.header.channels.size();
  if (auto* bytes = std::get_if<std::vector<std::uint8_t>>(&picture.samples))
    return {width, height, channels == 3 ? std::move(*bytes) : first_three(*bytes, channels)};
  if (const auto* words = std::get_if<std::vector<std::uint16_t>>(&picture.samples)) {
    std::vector<unsigned char> codes(words->size());
    std::transform(words->begin(), words->end(), codes.begin(),
                   [](std::uint32_t v) { return static_cast<unsigned char>((v * 255 + 32767) / 65535); });
    return {width, height, first_three(codes, channels)};
  }
  return to_codes(to_image(std::move(picture)), Encoding::kSrgb);
}

}  // namespace

Error unreadable_picture(const std::string& where, const std::string& reason) {
  return Error(where, "cannot be read as a picture: " + reason.substr(0, reason.find('\n')));
}

std::vector<std::string> default_channels(int count) {
  if (count <= 2) return count == 1 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"Y", "A"};
  std::vector<std::string> names{"R", "G", "B", "A"};
  for (int c = 4; c < count; ++c) names.push_back(fmt::format("channel{}", c));
  names.resize(static_cast<std::size_t>(count));
  return names;
}

PictureHeader picture_header(FileBytes file, const std::string& where) { return format_of(file, where).header(file, where); }

DecodedPicture decode_picture(FileBytes file, const std::string& where) { return format_of(file, where).decode(file, where); }

Image read_image(const fs::path& path) { return to_image(read_decoded(path)); }

std::vector<std::string> channel_names(const fs::path& path) { return read_header(path).channels; }

Image read_channels(const fs::path& path, std::span<const std::string> names) {
  DecodedPicture picture = read_decoded(path);
  const std::vector<std::string> known = picture.header.channels;
  std::vector<std::size_t> index;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) throw Error(path.string(), "has no channel " + name, fmt::format("{}", fmt::join(known, ", ")));
    index.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  const Image all = to_image(std::move(picture));
  Image chosen(all.width, all.height, static_cast<int>(index.size()));
  const std::size_t pixels = static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < index.size(); ++c) chosen.data[i * index.size() + c] = all.data[i * known.size() + index[c]];
  return chosen;
}

SampleKind sample_kind(const fs::path& path) { return read_header(path).kind; }

Image8 read_image8(const fs::path& path) { return to_image8(read_decoded(path)); }

Image8 read_new_image8(const fs::path& path) { return to_image8(decode_picture(read_new_file_bytes(path), path.string())); }

}  // namespace lippmann
