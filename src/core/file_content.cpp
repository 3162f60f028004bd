#include "core/file_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/printable.hpp"

namespace lippmann {
namespace {

using namespace std::string_view_literals;

struct KnownStart {
  std::string_view magic;
  std::size_t offset;
  std::string_view what;
};

constexpr std::array kKnownStarts{
    KnownStart{"\x89PNG\r\n\x1a\n"sv, 0, "a PNG picture"},
    KnownStart{"\xff\xd8\xff"sv, 0, "a JPEG picture"},
    KnownStart{"\x76\x2f\x31\x01"sv, 0, "an OpenEXR picture"},
    KnownStart{"II*\0"sv, 0, "a TIFF picture"},
    KnownStart{"MM\0*"sv, 0, "a TIFF picture"},
    KnownStart{"GIF8"sv, 0, "a GIF picture"},
    KnownStart{"BM"sv, 0, "a BMP picture"},
    KnownStart{"WEBP"sv, 8, "a WebP picture"},
    KnownStart{"8BPS"sv, 0, "a Photoshop file"},
    KnownStart{"DDS "sv, 0, "a DDS texture"},
    KnownStart{"\xabKTX"sv, 0, "a KTX texture"},
    KnownStart{"ftypavif"sv, 4, "an AVIF picture"},
    KnownStart{"ftypheic"sv, 4, "a HEIC picture"},
    KnownStart{"ftypmif1"sv, 4, "a HEIC picture"},
    KnownStart{"\0\0\0\x0cJXL "sv, 0, "a JPEG XL picture"},
    KnownStart{"\xff\x0a"sv, 0, "a JPEG XL picture"},
    KnownStart{"\0\0\0\x0cjP  "sv, 0, "a JPEG 2000 picture"},
    KnownStart{"qoif"sv, 0, "a QOI picture"},
    KnownStart{"#?RADIANCE"sv, 0, "a Radiance HDR picture"},
    KnownStart{"#?RGBE"sv, 0, "a Radiance HDR picture"},
    KnownStart{"ftyp"sv, 4, "an MP4 video"},
    KnownStart{"\x1a\x45\xdf\xa3"sv, 0, "a Matroska or WebM video"},
    KnownStart{"glTF"sv, 0, "a binary glTF scene (.glb)"},
    KnownStart{"ply\n"sv, 0, "a PLY file"},
    KnownStart{"ply\r"sv, 0, "a PLY file"},
    KnownStart{"BLENDER"sv, 0, "a Blender file"},
    KnownStart{"Kaydara FBX"sv, 0, "an FBX scene"},
    KnownStart{"PXR-USDC"sv, 0, "a USD scene"},
    KnownStart{"#usda"sv, 0, "a USD scene"},
    KnownStart{"\x89HDF\r\n\x1a\n"sv, 0, "an HDF5 file"},
    KnownStart{"PK\x03\x04"sv, 0, "a ZIP archive"},
    KnownStart{"PK\x05\x06"sv, 0, "a ZIP archive"},
    KnownStart{"\x1f\x8b"sv, 0, "data compressed by gzip"},
    KnownStart{"\x28\xb5\x2f\xfd"sv, 0, "data compressed by zstd"},
    KnownStart{"\xfd"
               "7zXZ\0"sv,
               0, "data compressed by xz"},
    KnownStart{"BZh"sv, 0, "data compressed by bzip2"},
    KnownStart{"7z\xbc\xaf\x27\x1c"sv, 0, "a 7z archive"},
    KnownStart{"Rar!\x1a\x07"sv, 0, "a RAR archive"},
    KnownStart{"%PDF-"sv, 0, "a PDF document"},
    KnownStart{"\x7f"
               "ELF"sv,
               0, "a program"},
    KnownStart{"\0\x05\x16\x07"sv, 0, "a file of macOS's metadata (AppleDouble)"},
};

constexpr std::string_view kDownload = "the file itself: download or export it again";

bool starts_with_any_case(std::string_view text, std::string_view lower_case) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return text.size() >= lower_case.size() &&
         std::equal(lower_case.begin(), lower_case.end(), text.begin(), [&](char l, char c) { return lower(c) == l; });
}

std::string_view without_leading_space(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

bool is_web_page(std::string_view text) {
  constexpr std::array kTags{"<!doctype html"sv, "<html"sv, "<head"sv, "<body"sv, "<script"sv, "<title"sv};
  return std::any_of(kTags.begin(), kTags.end(), [&](auto tag) { return starts_with_any_case(text, tag); });
}

bool is_text(std::string_view begin) {
  constexpr std::size_t kLooked = 512;
  return std::all_of(begin.begin(), begin.begin() + static_cast<std::ptrdiff_t>(std::min(begin.size(), kLooked)), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code >= 0x20 && code != 0x7f) || c == '\n' || c == '\r' || c == '\t' || c == '\f';
  });
}

bool is_netpbm_kind(std::string_view begin) {
  return begin.size() > 2 && begin[0] == 'P' && begin[1] >= '1' && begin[1] <= '7' &&
         std::string_view(" \t\r\n#").find(begin[2]) != std::string_view::npos;
}

std::string first_line(std::string_view text) { return std::string(text.substr(0, text.find_first_of("\r\n"))); }

std::string pointed_size(std::string_view pointer) {
  constexpr std::string_view kKey = "\nsize ";
  const std::size_t at = pointer.find(kKey);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = pointer.substr(at + kKey.size());
  const std::string_view digits = rest.substr(0, std::min(rest.find_first_not_of("0123456789"), rest.size()));
  return digits.empty() || digits.size() > 18 ? std::string() : fmt::format(" of {} bytes", digits);
}

std::optional<FileContent> find_stand_in(std::string_view begin) {
  if (begin.empty()) return FileContent{"empty (0 bytes)", std::string(kDownload)};
  if (begin.find_first_not_of('\0') == std::string_view::npos)
    return FileContent{"nothing but zero bytes", std::string(kDownload)};
  const std::string_view text = without_leading_space(begin);
  if (text.empty()) return FileContent{"nothing but white space", std::string(kDownload)};
  if (text.starts_with("version https://git-lfs.github.com/spec/") || text.starts_with("version https://hawser.github.com/"))
    return FileContent{fmt::format("a Git LFS pointer, which stands for a file{}", pointed_size(begin)),
                       "the file itself: run `git lfs pull` in its repository"};
  if (text.starts_with("/annex/objects/"))
    return FileContent{"a git-annex pointer", "the file itself: run `git annex get` in its repository"};
  if (is_web_page(text))
    return FileContent{"a web page (HTML)", "the file itself: download it from the page's own link (on GitHub: Raw)"};
  return std::nullopt;
}

}  // namespace

FileContent describe_content(std::span<const std::byte> bytes) {
  const std::string_view begin(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (const auto stand_in = find_stand_in(begin)) return *stand_in;
  const bool text_only = is_text(begin);
  for (const KnownStart& known : kKnownStarts)
    if ((known.magic.size() > 2 || !text_only) && begin.size() >= known.offset &&
        begin.substr(known.offset).starts_with(known.magic))
      return {std::string(known.what), {}};
  if (is_netpbm_kind(begin)) return {fmt::format("a netpbm picture ({})", begin.substr(0, 2)), {}};
  if (begin.starts_with("\xff\xfe") || begin.starts_with("\xfe\xff")) return {"text in UTF-16", {}};
  if (!text_only) return {"binary data of an unknown kind", {}};
  const std::string_view text = without_leading_space(begin);
  if (starts_with_any_case(text, "<?xml")) return {"an XML document", {}};
  if (starts_with_any_case(text, "<svg")) return {"an SVG drawing", {}};
  return {fmt::format("text that begins {}", shown(first_line(text))), {}};
}

std::optional<FileContent> stand_in_for_file(std::span<const std::byte> bytes) {
  return find_stand_in({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace lippmann
