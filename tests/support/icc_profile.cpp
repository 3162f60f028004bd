#include "support/icc_profile.hpp"

#include <string_view>

namespace lippmann::test {
namespace {

using namespace std::string_literals;

std::string fixed16(double value) { return big_endian(static_cast<std::uint32_t>(static_cast<std::int32_t>(value * 65536.0))); }

std::string size_text(std::size_t size) { return big_endian(static_cast<std::uint32_t>(size)); }

/// Returns the first 128 bytes of a profile under D50. `kind` is three names of four letters: device class, colour
/// space and connection space.
std::string header_with(const char* kind, std::size_t size) {
  std::string header(128, '\0');
  header.replace(0, 4, size_text(size)).replace(8, 4, "\2\x40\0\0"s).replace(12, 12, kind).replace(36, 4, "acsp");
  return header.replace(68, 12, "\0\0\xf6\xd6\0\1\0\0\0\0\xd3\x2d"s);
}

/// Returns a lookup table with two nodes per input channel. `nodes` holds `out` bytes for each node.
std::string table(int in, int out, const std::string& nodes) {
  std::string lut = "mft1\0\0\0\0"s + static_cast<char>(in) + static_cast<char>(out) + "\2\0"s;
  for (const double value : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) lut += fixed16(value);
  const auto add_identity = [&](int curves) {
    for (int i = 0; i < 256 * curves; ++i) lut += static_cast<char>(i % 256);
  };
  add_identity(in);
  lut += nodes;
  add_identity(out);
  return lut;
}

}  // namespace

std::string big_endian(std::uint32_t value, int size) {
  std::string text;
  for (int i = size; i-- > 0;) text += static_cast<char>(value >> 8 * i & 0xff);
  return text;
}

std::string profile_with(const Primaries& primaries, double gamma) {
  std::string table, data;
  const auto add = [&](std::string_view name, const std::string& tag) {
    table += std::string(name) + big_endian(static_cast<std::uint32_t>(132 + 7 * 12 + data.size())) +
             big_endian(static_cast<std::uint32_t>(tag.size()));
    data += tag + std::string((4 - tag.size() % 4) % 4, '\0');
  };
  add("desc", "desc" + std::string(4, '\0') + big_endian(5) + "Mine" + std::string(1, '\0'));
  for (std::size_t i = 0; i < 3; ++i) {
    std::string xyz = "XYZ " + std::string(4, '\0');
    for (const double value : primaries[i]) xyz += fixed16(value);
    add(std::array{"rXYZ", "gXYZ", "bXYZ"}[i], xyz);
    add(std::array{"rTRC", "gTRC", "bTRC"}[i],
        "curv" + std::string(4, '\0') + big_endian(1) + big_endian(static_cast<std::uint32_t>(gamma * 256.0), 2));
  }
  return header_with("mntrRGB XYZ ", 132 + table.size() + data.size()) + big_endian(7) + table + data;
}

std::string press_profile() {
  std::string nodes, inks;
  for (int node = 0; node < 16; ++node) nodes += node == 0 ? "\xff\x80\x80"s : "\0\x80\x80"s;
  // the first input, L*, varies most slowly
  for (int node = 0; node < 8; ++node) inks += node < 4 ? "\0\0\0\xff"s : "\0\0\0\0"s;
  const std::string to_lab = table(4, 3, nodes), from_lab = table(3, 4, inks);
  constexpr std::size_t kData = 128 + 4 + 2 * 12;
  return header_with("prtrCMYKLab ", kData + to_lab.size() + from_lab.size()) + big_endian(2) + "A2B0" + size_text(kData) +
         size_text(to_lab.size()) + "B2A0" + size_text(kData + to_lab.size()) + size_text(from_lab.size()) + to_lab + from_lab;
}

}  // namespace lippmann::test
