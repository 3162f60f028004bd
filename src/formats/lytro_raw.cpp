// Reads the raw pictures of Lytro cameras. The metadata keys are those of lytro_illum_public_schema.json 1.3.5. The
// F01's files store the same values under image.rawDetails.
//
// Two samples of 12 bits take three bytes, high bits first. Four samples of 10 bits take five bytes: the upper 8 bits
// of each, and a byte with their lower 2 bits, the first sample's in the lowest bits.
//
// The sensor sees the lenses from the exit pupil of the main lens, so their images are farther apart than the lenses,
// by the factor (pupil + gap) / pupil.
#include "formats/lytro_raw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/regular_file.hpp"
#include "formats/lfp_file.hpp"
#include "image/demosaic.hpp"
#include "image/limits.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kColors{"r", "gr", "gb", "b"};
constexpr NumberRange kCode{0.0, 4095.0}, kGain{1e-3, 1e3}, kMetres{1e-9, 10.0}, kOffsetMetres{-0.1, 0.1};

struct SensorLevels {
  std::array<double, 4> black{}, white{};
};

SensorLevels sensor_levels(const JsonFields& format) {
  SensorLevels levels;
  const JsonFields black = format.inner("black"), white = format.inner("white");
  for (std::size_t i = 0; i < kColors.size(); ++i) {
    levels.black[i] = black.number(kColors[i], kCode), levels.white[i] = white.number(kColors[i], kCode);
    if (!(levels.black[i] < levels.white[i])) white.reject(kColors[i], "is not above the black level", "a higher code");
  }
  return levels;
}

/// Returns the position of the red pixel among the first 2 x 2 pixels. The picture may begin at any pixel of the pattern
/// r,gr:gb,b.
Vec2i red_place(const JsonFields& mosaic) {
  mosaic.word("tile", {"r,gr:gb,b"});
  const auto corner = static_cast<int>(mosaic.word("upperLeftPixel", {kColors.begin(), kColors.end()}));
  return {corner % 2, corner / 2};
}

/// Index of a pixel's colour in the list r, gr, gb, b.
std::size_t color_at(int x, int y, Vec2i red) { return static_cast<std::size_t>(((x ^ red.x) & 1) + 2 * ((y ^ red.y) & 1)); }

template <class Put>
void unpack(std::span<const std::byte> bytes, int bits, std::size_t count, const Put& put) {
  const auto byte = [&](std::size_t i) { return std::to_integer<unsigned>(bytes[i]); };
  if (bits == 12)
    for (std::size_t i = 0, at = 0; i < count; i += 2, at += 3) {
      put(i, byte(at) << 4 | byte(at + 1) >> 4);
      put(i + 1, (byte(at + 1) & 15u) << 8 | byte(at + 2));
    }
  else
    for (std::size_t i = 0, at = 0; i < count; i += 4, at += 5)
      for (std::size_t k = 0; k < 4; ++k) put(i + k, byte(at + k) << 2 | (byte(at + 4) >> (2 * k) & 3u));
}

/// Scales the codes to light: 0 at the black level, 1 at the white level.
Image mosaic_of(std::span<const std::byte> codes, Vec2i size, int bits, const SensorLevels& levels, Vec2i red) {
  Image mosaic(size.x, size.y, 1);
  std::array<double, 4> scale{};
  for (std::size_t i = 0; i < 4; ++i) scale[i] = 1.0 / (levels.white[i] - levels.black[i]);
  unpack(codes, bits, mosaic.data.size(), [&](std::size_t i, unsigned code) {
    const auto width = static_cast<std::size_t>(size.x);
    const std::size_t color = color_at(static_cast<int>(i % width), static_cast<int>(i / width), red);
    mosaic.data[i] = static_cast<float>(std::clamp((code - levels.black[color]) * scale[color], 0.0, 1.0));
  });
  return mosaic;
}

LensGrid stated_grid(const JsonFields& devices, Vec2i size) {
  const JsonFields mla = devices.inner("mla"), sensor = devices.inner("sensor");
  const double pixel = sensor.number("pixelPitch", kMetres);
  const std::size_t tiling = mla.word("tiling", {"squareUniform", "hexUniformRowMajor", "hexUniformColumnMajor"});
  const JsonFields offset = mla.inner("sensorOffset");
  double pitch = mla.number("lensPitch", kMetres) / pixel;
  if (devices.has("lens") && devices.inner("lens").has("exitPupilOffset")) {
    const double pupil = devices.inner("lens").inner("exitPupilOffset").number("z", kMetres);
    pitch *= (pupil + offset.number_or("z", kOffsetMetres, 0.0)) / pupil;
  }
  if (!(pitch >= 2.0 && pitch <= 4096.0))
    mla.reject("lensPitch", fmt::format("is {:.4g} pixels", pitch), "from 2 to 4096 pixels of `pixelPitch`");
  const Vec2d middle = 0.5 * Vec2d(size) + Vec2d(offset.number("x", kOffsetMetres), offset.number("y", kOffsetMetres)) / pixel;
  LensGrid grid = lens_grid(pitch, mla.number("rotation", {-3.2, 3.2}), middle, static_cast<LensArrangement>(tiling));
  if (!mla.has("scaleFactor")) return grid;
  constexpr NumberRange kNearOne{0.5, 2.0};
  const double across = mla.inner("scaleFactor").number_or("x", kNearOne, 1.0),
               down = mla.inner("scaleFactor").number_or("y", kNearOne, 1.0);
  const bool is_swapped = grid.arrangement == LensArrangement::kHexagonalColumns;
  grid.pitch_px *= is_swapped ? down : across, grid.row_pitch_px *= is_swapped ? across : down;
  return grid;
}

void read_colors(const JsonFields& image, LytroRaw& raw) {
  if (!image.has("color")) return;
  const JsonFields color = image.inner("color");
  if (color.has("whiteBalanceGain")) {
    const JsonFields gain = color.inner("whiteBalanceGain");
    const double green = 0.5 * (gain.number("gr", kGain) + gain.number("gb", kGain));
    raw.gains = Vec3f(Vec3d(gain.number("r", kGain), green, gain.number("b", kGain)));
  }
  const char* matrix = color.has("ccm") ? "ccm" : "ccmRgbToSrgbArray";
  if (!color.has(matrix)) return;
  const std::vector<double> rows = color.numbers(matrix, 9, {-100.0, 100.0});
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      raw.srgb_from_camera[column][row] = static_cast<float>(rows[static_cast<std::size_t>(3 * row + column)]);
}

Json parsed_json(std::span<const std::byte> text, const std::string& where, const char* what) {
  Json json = json_from_text({reinterpret_cast<const char*>(text.data()), text.size()});
  if (json.is_discarded()) throw Error(where, fmt::format("its {} is not JSON", what), "an .lfr file as the camera writes it");
  return json;
}

/// Returns the first element of a list, which must be an object.
JsonFields first_of(const JsonFields& fields, std::string_view key) {
  const Json& list = fields.value(key);
  if (!list.is_array() || list.empty()) fields.reject(key, "is not a list of frames", "a raw picture as the camera writes it");
  return fields.element(key, list.front());
}

/// `frame` is the metadata document, or a part of it for white pictures of the F01.
LytroRaw lytro_of(std::span<const std::byte> codes, const JsonFields& frame) {
  const JsonFields image = frame.inner("image");
  if (image.has("representation")) image.word("representation", {"rawPacked"});
  const JsonFields details = image.has("rawDetails") ? image.inner("rawDetails") : image;
  const NumberRange side{16.0, kMaxImageSide};
  const Vec2i size(image.whole("width", side), image.whole("height", side));
  const JsonFields packing = details.inner("pixelPacking");
  const int bits = packing.whole("bitsPerPixel", {10.0, 12.0});
  if (bits == 11) packing.reject("bitsPerPixel", "is 11", "10 or 12");
  packing.word("endianness", {bits == 12 ? "big" : "little"});
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), group = bits == 12 ? 2 : 4;
  if (count % group != 0 || codes.size() < count / group * (bits == 12 ? 3 : 5))
    image.reject("width",
                 fmt::format("and height are {}x{}, which does not match {} bytes of {}-bit samples", size.x, size.y,
                             codes.size(), bits),
                 "a whole picture");
  const Vec2i red = red_place(details.inner("mosaic"));
  LytroRaw raw;
  raw.grid = stated_grid(frame.inner("devices"), size);
  raw.orientation = image.whole_or("orientation", {1.0, 8.0}, 1);
  read_colors(image, raw);
  raw.light = demosaic(mosaic_of(codes, size, bits, sensor_levels(details.inner("pixelFormat")), red), red);
  return raw;
}

std::string lower_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

/// Returns NAME.TXT or NAME.txt beside NAME.RAW; empty if neither exists.
fs::path metadata_beside(const fs::path& raw) {
  for (const char* ending : {".TXT", ".txt"})
    if (const fs::path path = fs::path(raw).replace_extension(ending); is_regular_file_there(path)) return path;
  return {};
}

}  // namespace

LytroRaw parse_lytro(std::span<const std::byte> codes, const std::string& metadata, const std::string& where) {
  const Json json = parsed_json(std::as_bytes(std::span(metadata)), where, "metadata");
  const JsonFields document(json, where, "");
  if (!document.has("master")) return lytro_of(codes, document);
  return lytro_of(codes, first_of(document.inner("master").inner("picture"), "frameArray").inner("frame").inner("metadata"));
}

LytroRaw parse_lfr(std::span<const std::byte> file, const std::string& where) {
  const std::vector<LfpSection> sections = lfp_sections(file, where);
  const auto table = std::find_if(sections.begin(), sections.end(), [](const LfpSection& s) { return s.kind == "LFM"; });
  if (table == sections.end()) throw Error(where, "has no section LFM", "an .lfr file as the camera writes it");
  const Json json = parsed_json(table->data, where, "document");
  const JsonFields document(json, where, "");
  if (!document.has("frames") && !document.has("picture"))
    throw Error(where, "contains no raw frame; it may be a processed picture", "an .lfr file as the camera writes it");
  const JsonFields frame = document.has("frames") ? first_of(document, "frames").inner("frame")
                                                  : first_of(document.inner("picture"), "frameArray").inner("frame");
  const LfpSection& metadata = lfp_section(sections, frame.text("metadataRef"), where);
  return parse_lytro(lfp_section(sections, frame.text("imageRef"), where).data,
                     {reinterpret_cast<const char*>(metadata.data.data()), metadata.data.size()}, where);
}

bool is_lytro_raw(const fs::path& path) {
  const std::string ending = lower_ending(path);
  if (ending == ".raw") return !metadata_beside(path).empty();
  if (ending == ".lfp" || ending == ".lfr") return true;
  constexpr std::size_t kBegin = 16;
  const std::string begin = read_file_begin(path, kBegin);
  return is_lfp(std::as_bytes(std::span(begin)));
}

LytroRaw read_lytro(const fs::path& path) {
  const std::vector<std::byte> bytes = read_file_bytes(path, kMaxImageFileBytes, "a raw picture of a Lytro camera");
  if (is_lfp(bytes)) return parse_lfr(bytes, path.string());
  const fs::path metadata = lower_ending(path) == ".raw" ? metadata_beside(path) : fs::path();
  if (metadata.empty())
    throw Error(path.string(), "does not begin like an .lfp or .lfr file", "a raw picture of a Lytro camera");
  constexpr std::uintmax_t kMaxMetadataBytes = 16 << 20;
  return parse_lytro(bytes, read_file_text(metadata, kMaxMetadataBytes), metadata.string());
}

Image16 developed(const LytroRaw& raw) {
  Image colors(raw.light.width, raw.light.height, 3);
  for (std::size_t i = 0; i < colors.data.size(); i += 3) {
    const Vec3f light(raw.light.data[i], raw.light.data[i + 1], raw.light.data[i + 2]);
    const Vec3f color = raw.srgb_from_camera * glm::min(raw.gains * light, Vec3f(1.0f));
    for (const int c : {0, 1, 2}) colors.data[i + static_cast<std::size_t>(c)] = color[c];
  }
  return to_codes16(colors, Encoding::kSrgb);
}

}  // namespace lippmann
