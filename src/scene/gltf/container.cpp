// Based on: Khronos Group, "glTF 2.0 Specification", 2021, section 4 "GLB File Format Specification".
// 1. A .glb begins with a header of three little-endian 32-bit words: magic, version, total length.
// 2. The chunks follow. A chunk consists of two words (length, type) and its data. The first chunk is JSON, and the optional
//    second chunk is BIN. Chunks of other types are skipped.
#include "scene/gltf/container.hpp"
#include "core/regular_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>

namespace lippmann::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian and is read without swapping bytes");

constexpr std::uint32_t kMagic = 0x46546c67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004e4942;   // "BIN\0"
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;

std::uint32_t word(Bytes bytes, std::size_t offset) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

std::string_view text(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

Container split_glb(Bytes contents, Report& report) {
  if (contents.size() < kHeaderBytes) report.fail("", "ends within the header of a .glb");
  if (word(contents, 4) != 2) report.fail("", fmt::format("is a .glb of version {}", word(contents, 4)), "version 2");
  const std::size_t length = word(contents, 8);
  if (length > contents.size())
    report.fail("", fmt::format("is truncated: its header states {} bytes, but the file has {}", length, contents.size()));
  if (length < contents.size())
    report.warn(fmt::format("{} bytes after the end of the glTF data are ignored", contents.size() - length));

  Container result;
  std::size_t offset = kHeaderBytes;
  for (std::size_t chunk = 0; offset < length; ++chunk) {
    const std::string where = element("chunk", chunk);
    if (length - offset < kChunkHeaderBytes) report.fail(where, "ends within the chunk's header");
    const std::size_t size = word(contents, offset);
    const std::uint32_t type = word(contents, offset + 4);
    offset += kChunkHeaderBytes;
    if (size > length - offset) report.fail(where, fmt::format("states {} bytes, but {} are left", size, length - offset));
    const Bytes payload = contents.subspan(offset, size);
    offset += size;
    if (chunk == 0 && type != kJsonChunk) report.fail(where, "is not JSON, as the first chunk of a .glb must be");
    if (chunk == 0) result.json = text(payload);
    if (chunk == 1 && type == kBinChunk) result.binary = payload;
  }
  if (!result.json.data()) report.fail("", "is a .glb without a JSON chunk");
  return result;
}

}  // namespace

Container split_container(Bytes contents, Report& report) {
  if (contents.size() >= sizeof kMagic && word(contents, 0) == kMagic) return split_glb(contents, report);
  return {text(contents), std::nullopt};
}

std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t limit, std::string_view element,
                                 const Report& report) {
  const std::string name = element.empty() ? std::string("the file") : shown(path.filename().string());
  RegularFile file(path);
  if (!file.problem().empty()) report.fail(element, fmt::format("{} {}", name, file.problem()));
  if (file.size() > limit)
    report.fail(element, fmt::format("{} has {} bytes", name, file.size()), fmt::format("at most {} bytes", limit));
  std::vector<std::byte> contents(static_cast<std::size_t>(file.size()));
  if (file.read(contents.data(), contents.size()) < contents.size()) report.fail(element, name + " cannot be read completely");
  return contents;
}

}  // namespace lippmann::gltf
