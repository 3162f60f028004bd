#include "image/read_image.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

#include "core/file_content.hpp"
#include "core/printable.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "image/color_profile.hpp"
#include "image/decode.hpp"
#include "image/icc_transform.hpp"
#include "image/limits.hpp"
#include "image/orientation.hpp"
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

/// TGA is last, because it has no magic number.
constexpr std::array kFormats{Format{is_png, png_header, decode_png},          Format{is_exr, exr_header, decode_exr},
                              Format{is_jpeg, jpeg_header, decode_jpeg},       Format{is_tiff, tiff_header, decode_tiff},
                              Format{is_hdr, hdr_header, decode_hdr},          Format{is_webp, webp_header, decode_webp},
                              Format{is_netpbm, netpbm_header, decode_netpbm}, Format{is_heic, heic_header, decode_heic},
                              Format{is_bmp, bmp_header, decode_bmp},          Format{is_gif, gif_header, decode_gif},
                              Format{is_tga, tga_header, decode_tga}};

const Format& format_of(FileBytes file, const std::string& where) {
  for (const Format& format : kFormats)
    if (format.begins(file)) return format;
  const FileContent content = describe_content(file);
  throw Error(where, "cannot be read as a picture: it is " + content.what,
              content.advice.empty()
                  ? "PNG, JPEG, TIFF, OpenEXR, Radiance HDR, WebP, HEIC, AVIF, BMP, GIF, PPM (P6), PGM (P5), PFM or TGA"
                  : content.advice);
}

std::vector<std::byte> bytes_in(const fs::path& path) { return read_recorded_bytes(path, kMaxImageFileBytes, "a picture"); }

PictureHeader read_header(const fs::path& path) { return picture_header(bytes_in(path), path.string()); }

/// Reads the header of a PNG or JPEG file from its first 256 KiB. Returns nothing for longer or damaged headers, and for other
/// formats, whose headers may refer to later parts of the file.
std::optional<PictureHeader> begun_header(const fs::path& path) {
  constexpr std::size_t kBeginBytes = std::size_t{256} << 10;
  const std::string begin = read_file_begin(path, kBeginBytes);
  const FileBytes bytes = std::as_bytes(std::span(begin));
  if (!is_png(bytes) && !is_jpeg(bytes)) return std::nullopt;
  try {
    return picture_header(bytes, path.string());
  } catch (const Error&) {
    return std::nullopt;
  }
}

DecodedPicture read_decoded(const fs::path& path, const PictureWarning& warn) {
  DecodedPicture picture = decode_picture(bytes_in(path), path.string());
  if (warn)
    for (const std::string& notice : picture.header.notices)
      warn(fmt::format("{}: {}.", path.string(), printable_line(notice)));
  return picture;
}

void require_colors(const PictureHeader& header, const fs::path& path) {
  if (header.colors > 0) return;
  const std::string names = shown(fmt::format("{}", fmt::join(header.channels, ", ")));
  std::string what = fmt::format("none of its channels is a colour: {}", names);
  const auto has = [&](const char* name) {
    return std::find(header.channels.begin(), header.channels.end(), name) != header.channels.end();
  };
  std::string missing;
  for (const char* color : {"R", "G", "B"})
    if (!has(color)) missing += fmt::format("{}{}", missing.empty() ? "" : " and ", color);
  if (header.channels.size() == 1)
    what = fmt::format("its only channel {} is not a colour", names);
  else if (has("R") || has("G") || has("B"))
    what = fmt::format("it has no channel {} beside its channels {}", missing, names);
  else if (has("X") && has("Y"))
    what += ", where Y beside X is a coordinate, not luminance";
  throw Error(path.string(), what, "channels named R, G and B, or Y, also within a layer");
}

bool is_rgb_alone(const PictureHeader& header) { return header.colors == 3 && header.channels.size() == 3; }

template <class Code>
std::vector<Code> rgb_of(const std::vector<Code>& codes, const PictureHeader& header) {
  const std::size_t channels = header.channels.size(), pixels = codes.size() / channels;
  const std::size_t step = header.colors == 3 ? 1 : 0;
  std::vector<Code> rgb(3 * pixels);
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

Image8 to_image8(DecodedPicture picture, const fs::path& path) {
  require_colors(picture.header, path);
  const PictureHeader header = picture.header;
  const int width = header.width, height = header.height;
  if (auto* bytes = std::get_if<std::vector<std::uint8_t>>(&picture.samples))
    return {width, height, is_rgb_alone(header) ? std::move(*bytes) : rgb_of(*bytes, header)};
  if (const auto* words = std::get_if<std::vector<std::uint16_t>>(&picture.samples)) {
    std::vector<unsigned char> codes(words->size());
    std::transform(words->begin(), words->end(), codes.begin(),
                   [](std::uint32_t v) { return static_cast<unsigned char>((v * 255 + 32767) / 65535); });
    return {width, height, rgb_of(codes, header)};
  }
  Image image = to_image(std::move(picture));
  if (!is_rgb_alone(header)) image.data = rgb_of(image.data, header);
  image.channels = 3;
  return to_codes(image, Encoding::kSrgb);
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

PictureHeader plain_header(int width, int height, int channels, SampleKind kind) {
  PictureHeader header{width, height, default_channels(channels), kind};
  header.colors = channels >= 3 ? 3 : 1;
  return header;
}

void add_aspect_notice(PictureHeader& header, double aspect) {
  constexpr double kSeen = 0.01;
  if (!(std::abs(aspect - 1.0) > kSeen)) return;
  header.notices.push_back(fmt::format("its pixels are {:.4g} times as wide as high, and are read as square", aspect));
}

PictureHeader picture_header(FileBytes file, const std::string& where) {
  return upright(format_of(file, where).header(file, where));
}

DecodedPicture decode_picture(FileBytes file, const std::string& where) {
  DecodedPicture picture = upright(format_of(file, where).decode(file, where));
  const std::vector<std::byte> profile = std::exchange(picture.header.profile, {});
  if (!profile.empty() && !apply_color_profile(profile, picture.header, picture.samples))
    picture.header.notices.push_back(color_profile_notice(profile));
  return picture;
}

Image read_image(const fs::path& path, const PictureWarning& warn) { return to_image(read_decoded(path, warn)); }

Image read_rgb(const fs::path& path, const PictureWarning& warn) {
  DecodedPicture picture = read_decoded(path, warn);
  require_colors(picture.header, path);
  const PictureHeader header = picture.header;
  Image image = to_image(std::move(picture));
  if (!is_rgb_alone(header)) image.data = rgb_of(image.data, header);
  image.channels = 3;
  return image;
}

std::optional<StoredDepth> read_stored_depth(const fs::path& path) {
  const std::vector<std::byte> file = bytes_in(path);
  return is_heic(file) ? decode_heic_depth(file, path.string()) : std::nullopt;
}

std::vector<std::string> channel_names(const fs::path& path) { return read_header(path).channels; }

namespace {

LeftOutChannels left_out_channels(const PictureHeader& header) {
  LeftOutChannels left_out;
  if (header.colors == 0) return left_out;  // read_rgb() throws for such a file
  for (std::size_t c = static_cast<std::size_t>(header.colors); c < header.channels.size(); ++c) {
    const std::string& name = header.channels[c];
    const std::size_t dot = name.find_last_of(".:/");
    std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
    std::transform(last.begin(), last.end(), last.begin(), [](unsigned char letter) { return std::tolower(letter); });
    if (c == static_cast<std::size_t>(header.colors) && (last == "a" || last == "alpha"))
      left_out.alpha = true;
    else
      left_out.others.push_back(name);
  }
  return left_out;
}

}  // namespace

LeftOutChannels left_out_channels(const fs::path& path) { return left_out_channels(read_header(path)); }

std::optional<Image> read_alpha(const fs::path& path) {
  std::optional<PictureHeader> header = begun_header(path);
  if (!header) header = read_header(path);
  if (!left_out_channels(*header).alpha) return std::nullopt;
  const std::array<std::string, 1> channel{header->channels[static_cast<std::size_t>(header->colors)]};
  Image alpha = read_channels(path, channel);
  for (float& value : alpha.data) value = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
  const bool is_opaque = std::all_of(alpha.data.begin(), alpha.data.end(), [](float value) { return value == 1.0f; });
  return is_opaque ? std::nullopt : std::optional(std::move(alpha));
}

Image read_channels(const fs::path& path, std::span<const std::string> names) {
  DecodedPicture picture = read_decoded(path, {});
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

PictureShape picture_shape(const fs::path& path) {
  std::optional<PictureHeader> header = begun_header(path);
  if (!header) header = read_header(path);
  return {header->width, header->height, header->kind};
}

Image8 read_image8(const fs::path& path, const PictureWarning& warn) { return to_image8(read_decoded(path, warn), path); }

Image8 read_new_image8(const fs::path& path) {
  return to_image8(decode_picture(read_file_bytes(path, kMaxImageFileBytes, "a picture"), path.string()), path);
}

}  // namespace lippmann
