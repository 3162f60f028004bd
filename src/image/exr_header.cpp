// Based on: Industrial Light & Magic, "OpenEXR File Layout", 2013. After a magic number and a version a header is a row of
// attributes, each a name, a type, a size and a value, ended by an empty name; in a file of several parts headers follow until
// an empty one.
//
// What OpenEXR takes from the file must be what is looked at here. It reads most values by their type, whatever their size
// says; so a size that does not fit its type is an error here, or what follows would be read as something else.
#include "image/exr_header.hpp"

#include <OpenEXR/ImfAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

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

/// Bytes that are read from the front. What is asked for and is not there is a truncated header.
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
  /// Followed by a zero, which belongs to it.
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
  /// A number of bytes, as 4 bytes with a sign.
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

/// Whether OpenEXR reads as many bytes as the value has. `type` is followed by a zero.
bool fits_type(std::string_view type, FileBytes value, const std::string& where) {
  const auto fixed = std::find_if(kSizes.begin(), kSizes.end(), [&](const auto& known) { return known.first == type; });
  if (fixed != kSizes.end()) return value.size() == fixed->second;
  if (type == "chlist") return is_channel_list(HeaderInput(value, where));
  if (type == "stringvector") return is_list_of_texts(HeaderInput(value, where));
  if (type == "preview") return is_preview(HeaderInput(value, where));
  if (type == "floatvector") return value.size() % sizeof(float) == 0;
  return type == "string" || !Imf::Attribute::knownType(type.data());
}

/// What decides how many chunks a part has.
struct PartSize {
  std::int32_t window[4] = {0, 0, -1, -1};  // x and y of the first pixel, of the last one
  std::uint32_t tile[2] = {0, 0};           // 0: scan lines
  std::uint8_t compression = Imf::NO_COMPRESSION;

  void set(std::string_view attribute, FileBytes value) {
    const auto copy = [&](void* to, std::size_t size) {
      if (value.size() >= size) std::memcpy(to, value.data(), size);
    };
    if (attribute == "dataWindow") copy(window, sizeof window);
    if (attribute == "tiles") copy(tile, sizeof tile);
    if (attribute == "compression") copy(&compression, sizeof compression);
  }
  std::uint64_t chunks(const std::string& where) const {
    const std::int64_t width = std::int64_t{window[2]} - window[0] + 1, height = std::int64_t{window[3]} - window[1] + 1;
    check_image_size(where, width, height, 1);
    if (compression >= Imf::NUM_COMPRESSION_METHODS) throw unreadable_picture(where, "its compression is of no known kind");
    const auto pieces = [](std::int64_t side, std::uint64_t piece) {
      return (static_cast<std::uint64_t>(side) + piece - 1) / piece;
    };
    if (tile[0] > 0 && tile[1] > 0) return pieces(width, tile[0]) * pieces(height, tile[1]);
    return pieces(height, exr_lines_per_chunk(static_cast<Imf::Compression>(compression)));
  }
};

std::uint64_t read_chunks_of_part(HeaderInput& input, const std::string& where) {
  PartSize size;
  for (std::string_view name = input.text(); !name.empty(); name = input.text()) {
    const std::string_view type = input.text();
    const FileBytes value = input.bytes(input.size());
    if (!fits_type(type, value, where))
      throw unreadable_picture(where, fmt::format("its attribute {} is no {}", printable(name), printable(type)));
    size.set(name, value);
  }
  return size.chunks(where);
}

}  // namespace

void check_exr_headers(FileBytes file, const std::string& where) {
  constexpr std::uint64_t kMagicAndVersion = 8, kPlaceBytes = 8;
  HeaderInput input(file, where);
  const bool several = std::to_integer<int>(input.bytes(kMagicAndVersion)[5]) & 0x10;
  std::uint64_t chunks = 0;
  do chunks += read_chunks_of_part(input, where);
  while (several && !input.begins_with_zero());
  if (chunks > file.size() / kPlaceBytes) throw input.truncated();
}

std::uint64_t exr_lines_per_chunk(Imf::Compression compression) {
  switch (compression) {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
      return 32;
    case Imf::DWAB_COMPRESSION:
      return 256;
    default:
      return 1;
  }
}

}  // namespace lippmann
