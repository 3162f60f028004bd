#include "image/read_image.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>

#include "core/error.hpp"
#include "image/encode.hpp"
#include "image/oiio.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

Error unreadable(const fs::path& path, std::string reason) {
  reason = reason.substr(0, reason.find('\n'));
  return Error(path.string(), "cannot be read as a picture" + (reason.empty() ? "" : ": " + reason));
}

/// OpenImageIO fills the missing part of a truncated JPEG with grey, and libpng complains on stderr: look for the end first.
void check_end_marker(const fs::path& path) {
  constexpr std::streamoff kTail = 4096;  // some writers append a little after the end
  std::ifstream in(path, std::ios::binary);
  std::array<char, 8> head{};
  in.read(head.data(), head.size());
  const std::string_view start(head.data(), head.size());
  const bool png = start == "\x89PNG\r\n\x1a\n", jpeg = start.starts_with("\xff\xd8\xff");
  if (!png && !jpeg) return;
  in.clear();
  in.seekg(0, std::ios::end);
  in.seekg(std::max<std::streamoff>(0, in.tellg() - kTail));
  const std::string tail{std::istreambuf_iterator<char>(in), {}};
  if (tail.find(png ? "IEND" : "\xff\xd9") == std::string::npos) throw unreadable(path, "the file is truncated");
}

std::unique_ptr<OIIO::ImageInput> open_picture(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw Error(path.string(), "there is no such file");
  if (!fs::is_regular_file(path, ignored)) throw Error(path.string(), "is not a file");
  check_end_marker(path);
  keep_oiio_single_threaded();
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) throw unreadable(path, OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  check_image_size(path.string(), spec.width, spec.height, spec.nchannels);
  if (spec.depth > 1 || spec.deep) throw unreadable(path, "volumes and deep pictures are not supported");
  input->threads(1);
  return input;
}

/// Memory grows with what has been read, so that a small file cannot claim much of it by its header alone.
template <class T>
std::vector<T> read_samples(const fs::path& path, OIIO::ImageInput& input, OIIO::TypeDesc type) {
  constexpr int kRowsPerStep = 64;
  const OIIO::ImageSpec spec = input.spec();
  const std::size_t row = static_cast<std::size_t>(spec.width) * spec.nchannels;
  std::vector<T> samples;
  samples.reserve(row * spec.height);
  if (spec.tile_width > 0) {
    samples.resize(row * spec.height);
    if (!input.read_image(0, 0, 0, spec.nchannels, type, samples.data())) throw unreadable(path, input.geterror());
    return samples;
  }
  for (int y = 0; y < spec.height; y += kRowsPerStep) {
    const int end = std::min(y + kRowsPerStep, spec.height);
    samples.resize(row * end);
    if (!input.read_scanlines(0, 0, spec.y + y, spec.y + end, 0, 0, spec.nchannels, type, samples.data() + row * y))
      throw unreadable(path, input.geterror());
  }
  return samples;
}

std::vector<unsigned char> first_three(const std::vector<unsigned char>& codes, int channels) {
  const std::size_t pixels = codes.size() / channels;
  const int step = channels >= 3 ? 1 : 0;
  std::vector<unsigned char> rgb(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i)
    for (int c = 0; c < 3; ++c) rgb[3 * i + c] = codes[i * channels + c * step];
  return rgb;
}

Image read_all(const fs::path& path, OIIO::ImageInput& input) {
  const OIIO::ImageSpec& spec = input.spec();
  Image image;
  image.width = spec.width, image.height = spec.height, image.channels = spec.nchannels;
  const auto normalise = [&](const auto& codes, float maximum) {
    image.data.resize(codes.size());
    std::transform(codes.begin(), codes.end(), image.data.begin(), [=](auto code) { return code / maximum; });
  };
  if (spec.format == OIIO::TypeUInt8)
    normalise(read_samples<unsigned char>(path, input, OIIO::TypeUInt8), 255.0f);
  else if (spec.format == OIIO::TypeUInt16)
    normalise(read_samples<std::uint16_t>(path, input, OIIO::TypeUInt16), 65535.0f);
  else
    image.data = read_samples<float>(path, input, OIIO::TypeFloat);
  return image;
}

}  // namespace

Image read_image(const fs::path& path) { return read_all(path, *open_picture(path)); }

std::vector<std::string> channel_names(const fs::path& path) { return open_picture(path)->spec().channelnames; }

Image read_channels(const fs::path& path, std::span<const std::string> names) {
  const std::unique_ptr<OIIO::ImageInput> input = open_picture(path);
  const std::vector<std::string> known = input->spec().channelnames;
  std::vector<std::size_t> index;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) throw Error(path.string(), "has no channel " + name, fmt::format("{}", fmt::join(known, ", ")));
    index.push_back(found - known.begin());
  }
  const Image all = read_all(path, *input);
  Image chosen(all.width, all.height, static_cast<int>(index.size()));
  const std::size_t pixels = static_cast<std::size_t>(all.width) * all.height;
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < index.size(); ++c) chosen.data[i * index.size() + c] = all.data[i * known.size() + index[c]];
  return chosen;
}

SampleKind sample_kind(const fs::path& path) {
  const OIIO::TypeDesc format = open_picture(path)->spec().format;
  return format == OIIO::TypeUInt8 ? SampleKind::kByte : format == OIIO::TypeUInt16 ? SampleKind::kWord : SampleKind::kFloat;
}

Image8 read_image8(const fs::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = open_picture(path);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.format == OIIO::TypeUInt8) {
    std::vector<unsigned char> codes = read_samples<unsigned char>(path, *input, OIIO::TypeUInt8);
    if (spec.nchannels != 3) codes = first_three(codes, spec.nchannels);
    return {spec.width, spec.height, std::move(codes)};
  }
  if (spec.format == OIIO::TypeUInt16) {
    const std::vector<std::uint16_t> wide = read_samples<std::uint16_t>(path, *input, OIIO::TypeUInt16);
    std::vector<unsigned char> codes(wide.size());
    std::transform(wide.begin(), wide.end(), codes.begin(), [](std::uint32_t v) { return (v * 255 + 32767) / 65535; });
    return {spec.width, spec.height, first_three(codes, spec.nchannels)};
  }
  return to_codes(read_all(path, *input), Encoding::kSrgb);
}

}  // namespace lippmann
