// Based on: Industrial Light & Magic, "OpenEXR File Layout", 2013. A file consists of:
// 1. a magic number and a version;
// 2. a header per part; with several parts, an empty header ends the list;
// 3. the offsets of the chunks, 8 bytes each, part by part;
// 4. the chunks.
//
// A header is a list of attributes (name, type, size, value), ended by an empty name. A chunk consists of the number of its
// part (only in files with several parts), its row (4 bytes) or its tile and level (16 bytes), its size and its samples.
//
// OpenEXR reads most values by their type and ignores the stored size, so a size that does not match the type is an error here.
#include "image/exr_header.hpp"

#include <OpenEXR/ImfAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/printable.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

constexpr std::array<std::pair<std::string_view, std::size_t>, 24> kSizes{{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};

class HeaderInput {
 public:
  HeaderInput(FileBytes bytes, const std::string& where) : rest_(bytes), where_(where) {}

  bool empty() const { return rest_.empty(); }
  bool begins_with_zero() const { return !rest_.empty() && rest_.front() == std::byte{0}; }

  FileBytes bytes(std::uint64_t count) {
    if (count > rest_.size()) throw truncated();
    const FileBytes taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  /// The zero that ends the text is not part of the result, but follows it in memory.
  std::string_view text() {
    const auto end = std::find(rest_.begin(), rest_.end(), std::byte{0});
    if (end == rest_.end()) throw truncated();
    const FileBytes taken = bytes(static_cast<std::uint64_t>(end - rest_.begin()) + 1);
    return {reinterpret_cast<const char*>(taken.data()), taken.size() - 1};
  }
  template <class Number>
  Number number() {
    Number value{};
    std::memcpy(&value, bytes(sizeof value).data(), sizeof value);
    return value;
  }
  std::uint64_t size() {
    const auto size = number<std::int32_t>();
    if (size < 0) throw truncated();
    return static_cast<std::uint64_t>(size);
  }
  Error truncated() const { return unreadable_picture(where_, "the file is truncated in its header"); }

 private:
  FileBytes rest_;
  const std::string& where_;
};

bool is_channel_list(HeaderInput value) {
  constexpr std::uint64_t kChannelBytes = 16;
  while (!value.text().empty()) value.bytes(kChannelBytes);
  return value.empty();
}

bool is_list_of_texts(HeaderInput value) {
  while (!value.empty()) value.bytes(value.size());
  return true;
}

bool is_preview(HeaderInput value) {
  const auto width = value.number<std::uint32_t>(), height = value.number<std::uint32_t>();
  if (width > kMaxImageSide || height > kMaxImageSide) return false;
  value.bytes(std::uint64_t{4} * width * height);
  return value.empty();
}

/// Returns whether `value` has the size that OpenEXR reads for this type. `type` must be followed by a zero byte in memory.
bool fits_type(std::string_view type, FileBytes value, const std::string& where) {
  const auto fixed = std::find_if(kSizes.begin(), kSizes.end(), [&](const auto& known) { return known.first == type; });
  if (fixed != kSizes.end()) return value.size() == fixed->second;
  if (type == "chlist") return is_channel_list(HeaderInput(value, where));
  if (type == "stringvector") return is_list_of_texts(HeaderInput(value, where));
  if (type == "preview") return is_preview(HeaderInput(value, where));
  if (type == "floatvector") return value.size() % sizeof(float) == 0;
  return type == "string" || !Imf::Attribute::knownType(type.data());
}

struct PartSize {
  std::int32_t window[4] = {0, 0, -1, -1};  // x and y of the first pixel, then of the last pixel
  std::uint32_t tile[2] = {0, 0};
  // Lower 4 bits: 0 for one level, 1 for mipmaps, 2 for ripmaps. Upper 4 bits: 1 if the sides of levels are rounded up.
  std::uint8_t levels = 0;
  std::uint8_t compression = Imf::NO_COMPRESSION;
  bool tiled = false, deep = false;

  void set(std::string_view attribute, FileBytes value) {
    const auto copy = [&](void* to, std::size_t at, std::size_t size) {
      if (value.size() >= at + size) std::memcpy(to, value.data() + at, size);
    };
    if (attribute == "dataWindow") copy(window, 0, sizeof window);
    if (attribute == "tiles") copy(tile, 0, sizeof tile), copy(&levels, sizeof tile, 1);
    if (attribute == "compression") copy(&compression, 0, sizeof compression);
    if (attribute == "type") {
      const std::string_view type(reinterpret_cast<const char*>(value.data()), value.size());
      tiled = type.ends_with("tile") || type == "tiledimage", deep = type.starts_with("deep");
    }
  }
  std::uint64_t chunks(const std::string& where) const {
    const std::int64_t width = std::int64_t{window[2]} - window[0] + 1, height = std::int64_t{window[3]} - window[1] + 1;
    check_image_size(where, width, height, 1);
    if (compression >= Imf::NUM_COMPRESSION_METHODS) throw unreadable_picture(where, "its compression is unknown");
    if (!tiled) return pieces(height, exr_lines_per_chunk(static_cast<Imf::Compression>(compression)));
    if (tile[0] == 0 || tile[1] == 0) throw unreadable_picture(where, "its tile size is invalid");
    return tiles(width, height);
  }
  std::uint64_t place_bytes() const { return tiled ? 16 : 4; }

 private:
  static std::uint64_t pieces(std::int64_t side, std::uint64_t piece) {
    return (static_cast<std::uint64_t>(side) + piece - 1) / piece;
  }
  bool rounds_up() const { return levels >> 4 != 0; }
  int level_count(std::int64_t side) const {
    const auto wide = static_cast<std::uint64_t>(side);
    return static_cast<int>(rounds_up() ? std::bit_width(wide - 1) : std::bit_width(wide) - 1) + 1;
  }
  std::int64_t level_side(std::int64_t side, int level) const {
    const std::int64_t rounding = rounds_up() ? (std::int64_t{1} << level) - 1 : 0;
    return std::max<std::int64_t>(1, (side + rounding) >> level);
  }
  std::uint64_t tiles(std::int64_t width, std::int64_t height) const {
    const auto of_levels = [&](int x, int y) {
      return pieces(level_side(width, x), tile[0]) * pieces(level_side(height, y), tile[1]);
    };
    const int mode = levels & 0xf;
    if (mode == 0) return of_levels(0, 0);
    std::uint64_t count = 0;
    if (mode == 1)
      for (int level = 0; level < level_count(std::max(width, height)); ++level) count += of_levels(level, level);
    else
      for (int y = 0; y < level_count(height); ++y)
        for (int x = 0; x < level_count(width); ++x) count += of_levels(x, y);
    return count;
  }
};

/// Throws Error for a window that OpenEXR rejects, with a clearer message.
void check_window_place(const std::string& name, FileBytes value, const std::string& where) {
  std::array<std::int32_t, 4> window{};
  std::memcpy(window.data(), value.data(), sizeof window);
  const std::int32_t left = window[0], top = window[1], right = window[2], bottom = window[3];
  const auto refuse = [&](const std::string& problem) {
    throw unreadable_picture(
        where, fmt::format("its {} window from ({}, {}) to ({}, {}) {}", name, left, top, right, bottom, problem));
  };
  if (left > right || top > bottom) refuse("holds no pixel");
  if (std::int64_t{right} - left >= kMaxImageSide || std::int64_t{bottom} - top >= kMaxImageSide)
    refuse(fmt::format("has sides of more than {} pixels", kMaxImageSide));
  constexpr std::int32_t kFarthest = std::numeric_limits<std::int32_t>::max() / 2;
  for (const std::int32_t place : window)
    if (place <= -kFarthest || place >= kFarthest) refuse("is too far from the origin");
}

void check_attribute(std::string_view name, FileBytes value, const std::string& where) {
  if (name == "displayWindow" && value.size() == 16) check_window_place("display", value, where);
  if (name == "dataWindow" && value.size() == 16) check_window_place("data", value, where);
  if (name != "pixelAspectRatio" || value.size() != sizeof(float)) return;
  float aspect = 0.0f;
  std::memcpy(&aspect, value.data(), sizeof aspect);
  constexpr float kMin = 1e-6f, kMax = 1e6f;
  if (!(aspect >= kMin && aspect <= kMax))
    throw unreadable_picture(where, fmt::format("its pixels are {} times as wide as high", aspect));
}

PartSize read_part_size(HeaderInput& input, bool tiled, const std::string& where) {
  PartSize size;
  size.tiled = tiled;
  for (std::string_view name = input.text(); !name.empty(); name = input.text()) {
    const std::string_view type = input.text();
    const FileBytes value = input.bytes(input.size());
    if (!fits_type(type, value, where))
      throw unreadable_picture(where,
                               fmt::format("its attribute {} does not have the type {}", printable(name), printable(type)));
    check_attribute(name, value, where);
    size.set(name, value);
  }
  return size;
}

/// Throws Error if the chunk at `place` ends beyond the file, where OpenEXR would read zeros.
void check_chunk(FileBytes file, std::uint64_t place, const PartSize& part, bool several, const std::string& where) {
  const auto truncated = [&] { return unreadable_picture(where, "the file is truncated"); };
  if (place == 0 || place > file.size()) throw truncated();
  HeaderInput chunk(file.subspan(static_cast<std::size_t>(place)), where);
  try {
    constexpr std::uint64_t kPartNumberBytes = 4;
    chunk.bytes(part.place_bytes() + (several ? kPartNumberBytes : 0));
    if (!part.deep) return void(chunk.bytes(chunk.size()));
    const auto table = chunk.number<std::uint64_t>(), samples = chunk.number<std::uint64_t>();
    chunk.number<std::uint64_t>();
    chunk.bytes(table), chunk.bytes(samples);
  } catch (const Error&) {
    throw truncated();
  }
}

}  // namespace

void check_exr_file(FileBytes file, const std::string& where) {
  constexpr std::uint64_t kMagicAndVersion = 8, kPlaceBytes = 8;
  HeaderInput input(file, where);
  const int flags = std::to_integer<int>(input.bytes(kMagicAndVersion)[5]);
  const bool several = flags & 0x10, tiled = flags & 0x02;
  std::vector<PartSize> parts;
  std::vector<std::uint64_t> chunks;
  std::uint64_t all = 0;
  do {
    parts.push_back(read_part_size(input, tiled, where));
    all += chunks.emplace_back(parts.back().chunks(where));
  } while (several && !input.begins_with_zero());
  if (several) input.bytes(1);
  if (all > file.size() / kPlaceBytes) throw input.truncated();
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (std::uint64_t i = 0; i < chunks[part]; ++i)
      check_chunk(file, input.number<std::uint64_t>(), parts[part], several, where);
}

std::uint64_t exr_lines_per_chunk(Imf::Compression compression) {
  constexpr int kHtj2k256 = 10, kHtj2k32 = 11;  // compression methods since OpenEXR 3.4
  switch (static_cast<int>(compression)) {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
    case kHtj2k32:
      return 32;
    case Imf::DWAB_COMPRESSION:
    case kHtj2k256:
      return 256;
    default:
      return 1;
  }
}

}  // namespace lippmann
