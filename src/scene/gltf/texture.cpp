// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 3.8 "Texture Data": PNG and JPEG, told apart by their
// first bytes; the first texel is the top left one; colour profiles and orientation tags in the image are to be ignored.
#include "scene/gltf/texture.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace lippmann::gltf {
namespace {

constexpr unsigned char kPng[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr unsigned char kJpeg[] = {0xff, 0xd8, 0xff};

template <std::size_t N>
bool begins_with(Bytes bytes, const unsigned char (&magic)[N]) {
  return bytes.size() >= N && std::memcmp(bytes.data(), magic, N) == 0;
}

/// OpenImageIO's name for the format; only readers for what glTF allows are ever given a file's bytes.
const char* format_of(Bytes bytes) {
  if (begins_with(bytes, kPng)) return "png";
  if (begins_with(bytes, kJpeg)) return "jpeg";
  return nullptr;
}

/// Whether a PNG's chunks (length, type, data, checksum) go on to the last one. libpng finds that out too, but says so on
/// stderr.
bool is_whole_png(Bytes png) {
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

Wrap wrap_mode(int mode, const std::string& where, const Report& report) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
      return Wrap::kRepeat;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::kMirror;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::kClamp;
    default:
      report.fail(where, fmt::format("has the wrap mode {}", mode), "10497 (repeat), 33071 (clamp), 33648 (mirror)");
  }
}

}  // namespace

int TextureReader::read(int index, bool srgb) {
  const tinygltf::Texture& texture = document_.model.textures[static_cast<std::size_t>(index)];
  const std::string where = element("textures", static_cast<std::size_t>(index));
  if (texture.source < 0) {
    document_.report.warn_at("textures without a PNG or JPEG image are white", where);
    return -1;
  }
  tinygltf::Sampler sampler;
  if (texture.sampler >= 0) sampler = document_.model.samplers[static_cast<std::size_t>(texture.sampler)];
  const std::string sampler_where = element("samplers", static_cast<std::size_t>(std::max(texture.sampler, 0)));
  if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
    document_.report.not_supported("nearest-neighbour filtering is", "textures are filtered linearly", sampler_where);
  const Wrap wrap_u = wrap_mode(sampler.wrapS, sampler_where, document_.report);
  const Wrap wrap_v = wrap_mode(sampler.wrapT, sampler_where, document_.report);

  const auto [known, is_new] =
      known_.try_emplace({texture.source, wrap_u, wrap_v, srgb}, static_cast<int>(scene_.textures.size()));
  if (!is_new) return known->second;
  Texture result;
  const std::size_t image = static_cast<std::size_t>(texture.source);
  result.name = !document_.images[image].name.empty() ? document_.images[image].name : texture.name;
  result.wrap_u = wrap_u, result.wrap_v = wrap_v;
  result.srgb = srgb;
  decode(image, result);
  scene_.textures.push_back(std::move(result));
  return known->second;
}

void TextureReader::decode(std::size_t image, Texture& into) {
  const std::string where = element("images", image);
  const Report& report = document_.report;
  std::vector<std::byte> storage;
  const Bytes encoded = image_bytes(document_, image, storage);
  const char* format = format_of(encoded);
  if (!format) report.fail(where, "is neither PNG nor JPEG");
  if (begins_with(encoded, kPng) && !is_whole_png(encoded)) report.fail(where, "is a truncated PNG image");

  OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(encoded.data()), encoded.size());  // which only reads
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;  // colour is not to be multiplied by alpha
  const auto problem = [&](const std::string& text) {
    report.fail(where, fmt::format("is not a readable {} image: {}", format, printable(text)));
  };
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
  if (!input) report.fail(where, fmt::format("cannot be read: OpenImageIO has no {} reader", format));
  OIIO::ImageSpec spec;
  input->set_ioproxy(&memory);
  if (!input->open("", spec, config)) problem(input->geterror());

  const int longest = std::max(spec.width, spec.height);
  if (spec.width < 1 || spec.height < 1 || longest > document_.limits.texture_side)
    report.fail(where, fmt::format("has {} x {} pixels", spec.width, spec.height),
                fmt::format("1 to {} a side", document_.limits.texture_side));
  const std::uint64_t bytes = 4ull * static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
  if (bytes > left_)
    report.fail(where, "the textures decode to too much memory",
                fmt::format("at most {} bytes together", document_.limits.texture_bytes));
  left_ -= bytes;
  if (spec.nchannels < 1) problem("no channels");

  into.width = spec.width, into.height = spec.height;
  into.rgba.resize(bytes);
  const int channels = std::min(spec.nchannels, 4);
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, into.rgba.data())) problem(input->geterror());
  expand_to_rgba(into.rgba, channels);
}

}  // namespace lippmann::gltf
