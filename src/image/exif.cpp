// Based on: CIPA DC-008, "Exif 2.32", 2019, section 4.6. EXIF data begin with a TIFF header: byte order, the number 42, and the
// offset of a directory. A directory is the number of its entries, followed by the entries. An entry has 12 bytes: tag, type,
// count and value.
#include "image/exif.hpp"

#include <cstring>
#include <optional>
#include <string_view>

#include "image/orientation.hpp"

namespace lippmann {
namespace {

class ExifBytes {
 public:
  explicit ExifBytes(FileBytes bytes) : bytes_(bytes), low_first_(!bytes.empty() && bytes[0] == std::byte{'I'}) {}

  std::optional<std::uint32_t> number(std::uint64_t at, std::size_t size) const {
    if (at > bytes_.size() || bytes_.size() - at < size) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | std::to_integer<std::uint32_t>(bytes_[at + (low_first_ ? size - 1 - i : i)]);
    return value;
  }

 private:
  FileBytes bytes_;
  bool low_first_;
};

}  // namespace

Orientation exif_orientation(FileBytes exif) {
  constexpr std::string_view kName("Exif\0\0", 6);
  if (exif.size() >= kName.size() && std::memcmp(exif.data(), kName.data(), kName.size()) == 0)
    exif = exif.subspan(kName.size());
  const ExifBytes bytes(exif);
  constexpr std::uint32_t kMark = 42, kOrientationTag = 0x112, kShort = 3, kLong = 4;
  if (bytes.number(2, 2) != kMark) return Orientation::kUpright;
  const std::uint64_t directory = bytes.number(4, 4).value_or(0);
  const std::uint32_t entries = bytes.number(directory, 2).value_or(0);
  for (std::uint32_t i = 0; i < entries; ++i) {
    const std::uint64_t entry = directory + 2 + std::uint64_t{12} * i;
    if (bytes.number(entry, 2) != kOrientationTag) continue;
    const auto type = bytes.number(entry + 2, 2);
    if (type != kShort && type != kLong) return Orientation::kUpright;
    return orientation_of(bytes.number(entry + 8, type == kShort ? 2 : 4).value_or(1));
  }
  return Orientation::kUpright;
}

}  // namespace lippmann
