// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.8 "Texture Data": the first texel is the top left one;
// colour profiles and orientation tags in the image are to be ignored. The other formats say nothing else.
#include "scene/texture_image.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "core/error.hpp"
#include "core/printable.hpp"

namespace lippmann {
namespace {

constexpr unsigned char kPng[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr unsigned char kJpeg[] = {0xff, 0xd8, 0xff};

template <std::size_t N>
bool begins_with(std::span<const std::byte> bytes, const unsigned char (&magic)[N]) {
  return bytes.size() >= N && std::memcmp(bytes.data(), magic, N) == 0;
}

/// OpenImageIO's name for the format; only readers for what glTF allows are ever given a file's bytes.
const char* format_of(std::span<const std::byte> bytes) {
  if (begins_with(bytes, kPng)) return "png";
  if (begins_with(bytes, kJpeg)) return "jpeg";
  return nullptr;
}

/// Whether a PNG's chunks (length, type, data, checksum) go on to the last one. libpng finds that out too, but says so on
/// stderr.
bool is_whole_png(std::span<const std::byte> png) {
  std::size_t at = sizeof kPng;
  while (png.size() - at >= 12) {
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | std::to_integer<std::uint64_t>(png[at + i]);
    if (length > png.size() - at - 12) return false;
    if (std::memcmp(png.data() + at + 4, "IEND", 4) == 0) return true;
    at += 12 + static_cast<std::size_t>(length);
  }
  return false;
}

/// Grey, grey and alpha, RGB or RGBA to RGBA, in place: `rgba` holds the pixels with `channels` each at its front.
void expand_to_rgba(std::vector<std::uint8_t>& rgba, int channels) {
  for (std::size_t i = rgba.size() / 4; i-- > 0;) {
    std::uint8_t texel[4] = {0, 0, 0, 255};
    std::memcpy(texel, rgba.data() + i * static_cast<std::size_t>(channels), static_cast<std::size_t>(channels));
    if (channels == 2) texel[3] = texel[1];
    if (channels <= 2) texel[1] = texel[2] = texel[0];
    std::memcpy(rgba.data() + 4 * i, texel, 4);
  }
}

/// Counts the picture's texels.
void spend(const OIIO::ImageSpec& spec, const std::string& where, TextureBudget& budget) {
  if (spec.width < 1 || spec.height < 1 || std::max(spec.width, spec.height) > budget.longest_side)
    throw Error(where, fmt::format("has {} x {} pixels", spec.width, spec.height),
                fmt::format("1 to {} a side", budget.longest_side));
  const std::uint64_t bytes = 4ull * static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
  if (bytes > budget.left)
    throw Error(where, "the textures decode to too much memory", fmt::format("at most {} bytes together", budget.bytes));
  budget.left -= bytes;
}

}  // namespace

bool is_texture_image(std::span<const std::byte> encoded) { return format_of(encoded) != nullptr; }

void decode_texture(std::span<const std::byte> encoded, const std::string& where, TextureBudget& budget, Texture& into) {
  const char* format = format_of(encoded);
  if (!format) throw Error(where, "is neither PNG nor JPEG");
  if (begins_with(encoded, kPng) && !is_whole_png(encoded)) throw Error(where, "is a truncated PNG image");

  OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(encoded.data()), encoded.size());  // which only reads
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;  // colour is not to be multiplied by alpha
  const auto unreadable = [&](const std::string& text) {
    return Error(where, fmt::format("is not a readable {} image: {}", format, printable(text)));
  };
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
  if (!input) throw Error(where, fmt::format("cannot be read: OpenImageIO has no {} reader", format));
  OIIO::ImageSpec spec;
  input->set_ioproxy(&memory);
  if (!input->open("", spec, config)) throw unreadable(input->geterror());
  spend(spec, where, budget);
  if (spec.nchannels < 1) throw unreadable("no channels");

  into.width = spec.width, into.height = spec.height;
  into.rgba.resize(4 * static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
  const int channels = std::min(spec.nchannels, 4);
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, into.rgba.data())) throw unreadable(input->geterror());
  expand_to_rgba(into.rgba, channels);
}

}  // namespace lippmann
