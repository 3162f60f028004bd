// Based on: Khronos Group and A. Kapoulkine, "EXT_meshopt_compression", 2021, with the codecs and filters of meshoptimizer.
//
// Before allocating memory, we check that the compressed bytes can contain the stated number of elements: the vertex codec
// needs at least 2 bits per 16 bytes, and the index codecs one byte per index or triangle.
#include "scene/gltf/meshopt.hpp"

#include <fmt/format.h>
#include <meshoptimizer.h>

namespace lippmann::gltf {
namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";

std::string where_of(std::size_t view) { return element("bufferViews", view) + ".extensions." + kMeshopt; }

Bytes packed_bytes(const Document& document, const PackedView& view, const std::string& where) {
  const Bytes buffer = document.buffers[static_cast<std::size_t>(view.buffer)];
  if (view.byte_offset > buffer.size() || view.byte_length > buffer.size() - view.byte_offset)
    document.report.fail(where, fmt::format("{} bytes from byte {} on lie outside buffers[{}], which has {} bytes",
                                            view.byte_length, view.byte_offset, view.buffer, buffer.size()));
  return buffer.subspan(view.byte_offset, view.byte_length);
}

void check_shape(const PackedView& view, const std::string& where, const Report& report) {
  const bool attributes = view.mode == "ATTRIBUTES", whole_words = view.byte_stride % 4 == 0;
  const auto fail = [&](std::string_view what, const std::string& accepted) {
    report.fail(where, fmt::format("{} cannot have elements of {} bytes", what, view.byte_stride), accepted);
  };
  if (attributes && !whole_words) fail("mode ATTRIBUTES", "a byteStride of 4, 8, ... 256");
  if (!attributes && view.byte_stride != 2 && view.byte_stride != 4) fail(view.mode, "2, 4");
  if (!attributes && view.filter != "NONE") report.fail(where, "has a filter for " + view.mode, "filters for ATTRIBUTES only");
  if (view.filter == "OCTAHEDRAL" && view.byte_stride != 4 && view.byte_stride != 8) fail(view.filter, "4, 8");
  if (view.filter == "QUATERNION" && view.byte_stride != 8) fail(view.filter, "8");
  if (view.mode == "TRIANGLES" && view.count % 3 != 0)
    report.fail(where, fmt::format("has {} indices for triangles", view.count), "a multiple of 3");
}

void check_count(const PackedView& view, const std::string& where, const Report& report) {
  constexpr std::uint64_t kBestRatio = 64;
  const std::uint64_t most = view.mode == "ATTRIBUTES"  ? kBestRatio * view.byte_length / view.byte_stride
                             : view.mode == "TRIANGLES" ? 3 * view.byte_length
                                                        : view.byte_length;
  if (view.count > most)
    report.fail(where, fmt::format("cannot hold {} elements in {} bytes", view.count, view.byte_length),
                fmt::format("at most {}", most));
}

bool decode(const PackedView& view, Bytes packed, std::vector<std::byte>& out) {
  const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
  if (view.mode == "TRIANGLES")
    return meshopt_decodeIndexBuffer(out.data(), view.count, view.byte_stride, from, packed.size()) == 0;
  if (view.mode == "INDICES")
    return meshopt_decodeIndexSequence(out.data(), view.count, view.byte_stride, from, packed.size()) == 0;
  return meshopt_decodeVertexBuffer(out.data(), view.count, view.byte_stride, from, packed.size()) == 0;
}

void unfilter(const PackedView& view, std::vector<std::byte>& out) {
  if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), view.count, view.byte_stride);
  if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), view.count, view.byte_stride);
  if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), view.count, view.byte_stride);
}

std::vector<std::byte> unpack_view(Document& document, const PackedView& view, const std::string& where) {
  const Bytes packed = packed_bytes(document, view, where);
  document.unpacked.spend(view.count, view.byte_stride, where, document.report);
  std::vector<std::byte> out(view.count * view.byte_stride);
  if (!decode(view, packed, out)) document.report.fail(where, fmt::format("cannot be decoded as {}", view.mode));
  unfilter(view, out);
  return out;
}

}  // namespace

std::optional<PackedView> packed_view(Value view) {
  const Value packed = view.extension(kMeshopt);
  if (!packed) return std::nullopt;
  return PackedView{.buffer = packed["buffer"].index(),
                    .byte_offset = packed["byteOffset"].count(),
                    .byte_length = packed["byteLength"].count(),
                    .byte_stride = packed["byteStride"].count(),
                    .count = packed["count"].count(),
                    .mode = packed["mode"].text(),
                    .filter = packed["filter"] ? packed["filter"].text() : "NONE"};
}

bool is_fallback(Value buffer) { return buffer.extension(kMeshopt)["fallback"].flag(false); }

void check_packed_views(const Document& document) {
  for (std::size_t i = 0; i < document.packed_views.size(); ++i) {
    if (!document.packed_views[i]) continue;
    const PackedView& view = *document.packed_views[i];
    packed_bytes(document, view, where_of(i));
    check_shape(view, where_of(i), document.report);
    check_count(view, where_of(i), document.report);
  }
}

void unpack_views(Document& document) {
  for (std::size_t i = 0; i < document.packed_views.size(); ++i) {
    if (!document.packed_views[i]) continue;
    const std::string where = where_of(i);
    document.loaded.push_back(unpack_view(document, *document.packed_views[i], where));
    BufferView& view = document.buffer_views[i];
    view.buffer = static_cast<int>(document.buffers.size());
    view.byte_offset = 0;
    view.byte_length = document.loaded.back().size();
    document.buffers.push_back(document.loaded.back());
  }
}

}  // namespace lippmann::gltf
