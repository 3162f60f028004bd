// Based on: ICC.1:2022, "Image technology colour management". A profile is a header of 128 bytes, a table of tags (signature,
// offset, size) and their data. For a screen, rXYZ, gXYZ and bXYZ are the colours of the primaries under D50, and rTRC, gTRC
// and bTRC (for grey: kTRC) the transfer curves. A curve is a gamma, a table of 16-bit values, or one of five functions.
#include "image/color_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "core/printable.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

class IccProfile {
 public:
  explicit IccProfile(FileBytes bytes) : bytes_(bytes) {}

  bool is_profile() const {
    constexpr std::size_t kSignatureAt = 36;
    return bytes_.size() >= 132 && std::memcmp(bytes_.data() + kSignatureAt, "acsp", 4) == 0;
  }
  std::string_view color_space() const { return text(bytes_.subspan(16, 4)); }

  FileBytes tag(std::string_view name) const {
    const std::size_t count = whole(bytes_, 128);
    for (std::size_t i = 0, at = 132; i < count && at + 12 <= bytes_.size(); ++i, at += 12) {
      if (text(bytes_.subspan(at, 4)) != name) continue;
      const std::size_t begin = whole(bytes_, at + 4), size = whole(bytes_, at + 8);
      return begin <= bytes_.size() && size <= bytes_.size() - begin ? bytes_.subspan(begin, size) : FileBytes{};
    }
    return {};
  }

  /// Reads a big-endian integer, or 0 beyond the end.
  static std::uint32_t whole(FileBytes bytes, std::size_t at, std::size_t size = 4) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | (at + i < bytes.size() ? std::to_integer<std::uint32_t>(bytes[at + i]) : 0);
    return value;
  }
  /// The file stores 16 integer and 16 fractional bits.
  static double fixed(FileBytes bytes, std::size_t at) { return static_cast<std::int32_t>(whole(bytes, at)) / 65536.0; }
  static std::string_view text(FileBytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

  /// Returns the description in ASCII. Profiles of version 4 store UTF-16; the low byte of each character is taken.
  std::string name() const {
    const FileBytes tag = this->tag("desc");
    if (tag.size() < 12) return "";
    if (text(tag.first(4)) == "desc") {
      const std::size_t size = std::min<std::size_t>(whole(tag, 8), tag.size() - 12);
      return std::string(text(tag.subspan(12, size)).substr(0, text(tag.subspan(12, size)).find('\0')));
    }
    const std::size_t size = whole(tag, 20), begin = whole(tag, 24);
    std::string name;
    for (std::size_t i = begin + 1; i < begin + size && i < tag.size(); i += 2) name += static_cast<char>(tag[i]);
    return name;
  }

 private:
  FileBytes bytes_;
};

bool has_color(const IccProfile& profile, std::string_view tag, std::array<double, 3> xyz) {
  constexpr double kRounded = 0.004;
  const FileBytes value = profile.tag(tag);
  for (std::size_t c = 0; c < 3; ++c)
    if (value.size() < 20 || std::abs(IccProfile::fixed(value, 8 + 4 * c) - xyz[c]) > kRounded) return false;
  return true;
}

std::optional<double> curve_at_half(FileBytes curve) {
  const std::string_view kind = IccProfile::text(curve.first(std::min<std::size_t>(4, curve.size())));
  if (kind == "curv") {
    const std::size_t count = IccProfile::whole(curve, 8);
    if (count == 0) return 0.5;
    if (count == 1) return std::pow(0.5, IccProfile::whole(curve, 12, 2) / 256.0);
    const std::size_t low = (count - 1) / 2, high = count / 2;
    return (IccProfile::whole(curve, 12 + 2 * low, 2) + IccProfile::whole(curve, 12 + 2 * high, 2)) / (2.0 * 65535.0);
  }
  if (kind != "para") return std::nullopt;
  std::array<double, 7> p{};  // parameters g, a, b, c, d, e, f
  const std::uint32_t function = IccProfile::whole(curve, 8, 2);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = IccProfile::fixed(curve, 12 + 4 * i);
  const double x = 0.5;
  switch (function) {
    case 0:
      return std::pow(x, p[0]);
    case 1:
      return x >= -p[2] / p[1] ? std::pow(p[1] * x + p[2], p[0]) : 0.0;
    case 2:
      return x >= -p[2] / p[1] ? std::pow(p[1] * x + p[2], p[0]) + p[3] : p[3];
    case 3:
      return x >= p[4] ? std::pow(p[1] * x + p[2], p[0]) : p[3] * x;
    case 4:
      return x >= p[4] ? std::pow(p[1] * x + p[2], p[0]) + p[5] : p[3] * x + p[6];
    default:
      return std::nullopt;
  }
}

bool has_srgb_curve(const IccProfile& profile, std::string_view tag) {
  constexpr double kUnseen = 0.01;  // largest invisible difference of linear values; gamma 2.2 differs from sRGB by 0.004
  const std::optional<double> half = curve_at_half(profile.tag(tag));
  return half && std::abs(*half - linear_from_srgb(0.5)) <= kUnseen;
}

bool is_srgb(const IccProfile& profile) {
  if (profile.color_space() == "GRAY") return has_srgb_curve(profile, "kTRC");
  return profile.color_space() == "RGB " && has_color(profile, "rXYZ", {0.4361, 0.2225, 0.0139}) &&
         has_color(profile, "gXYZ", {0.3851, 0.7169, 0.0971}) && has_color(profile, "bXYZ", {0.1431, 0.0606, 0.7139}) &&
         has_srgb_curve(profile, "rTRC") && has_srgb_curve(profile, "gTRC") && has_srgb_curve(profile, "bTRC");
}

}  // namespace

std::string color_profile_notice(FileBytes icc) {
  const IccProfile profile(icc);
  if (!profile.is_profile() || is_srgb(profile)) return {};
  const std::string name = profile.name();
  return fmt::format("its colour profile {} is not applied: its samples are read as if they had none",
                     shown(name.empty() ? "without a name" : name));
}

std::vector<std::byte> profile_to_apply(FileBytes icc) {
  const IccProfile profile(icc);
  if (!profile.is_profile() || is_srgb(profile)) return {};
  return {icc.begin(), icc.end()};
}

}  // namespace lippmann
