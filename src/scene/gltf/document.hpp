#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/gltf.hpp"
#include "scene/gltf/container.hpp"
#include "scene/gltf/report.hpp"
#include "scene/gltf/value.hpp"
#include "scene/side_file.hpp"

namespace lippmann::gltf {

class Budget {
 public:
  explicit Budget(std::uint64_t bytes) : limit_(bytes), left_(bytes) {}
  /// Subtracts `count` objects of `size` bytes from the remaining bytes. Throws Error at `element` if not enough bytes remain.
  void spend(std::uint64_t count, std::uint64_t size, std::string_view element, const Report& report);

 private:
  std::uint64_t limit_, left_;
};

struct BufferView {
  int buffer = 0;
  std::size_t byte_offset = 0, byte_length = 0;
  std::size_t byte_stride = 0;  ///< 0: the elements are contiguous
};

/// glTF's component types and their numbers.
enum class ComponentType : int { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt = 5125, kFloat };

struct Sparse {
  std::size_t count = 0;
  int index_view = 0, value_view = 0;
  std::size_t index_offset = 0, value_offset = 0;
  ComponentType index_type = ComponentType::kUnsignedInt;
};

struct Accessor {
  int buffer_view = -1;  ///< -1: all elements are zero
  std::size_t byte_offset = 0, count = 0;
  ComponentType component_type = ComponentType::kFloat;
  bool normalized = false;
  int components = 1;
  int matrix_side = 0;
  std::optional<Sparse> sparse;
};

struct PackedView {
  int buffer = 0;
  std::size_t byte_offset = 0, byte_length = 0;
  std::size_t byte_stride = 0, count = 0;
  std::string mode, filter;
};

/// A document. After reading, every index in `root` is valid, every buffer view lies within its buffer, and every accessor
/// within its buffer views.
struct Document {
  Document(const std::filesystem::path& path, const LoadOptions& options, const Context& context, const GltfLimits& file_limits)
      : folders{path.parent_path(), options.asset_root},
        texture_bytes(options.texture_bytes),
        limits(file_limits),
        report(path.string(), context),
        unpacked(limits.unpacked_bytes) {}

  SideFolders folders;
  std::uint64_t texture_bytes;
  GltfLimits limits;
  Report report;
  Budget unpacked;
  Value root;
  std::vector<Bytes> buffers;
  std::vector<BufferView> buffer_views;
  std::vector<std::optional<PackedView>> packed_views;
  std::vector<Accessor> accessors;

  Value at(std::string_view array, int index) const { return root[array].at(static_cast<std::size_t>(index)); }
  const Accessor& accessor(int index) const { return accessors[static_cast<std::size_t>(index)]; }
  Bytes view(int index) const;

  std::shared_ptr<const nlohmann::json> json;
  std::vector<std::byte> contents;
  std::vector<std::vector<std::byte>> loaded;
};

/// Reads a document from the contents of a file, without decompressing data or checking byte ranges. Warns about ignored
/// extensions.
void read_document(std::vector<std::byte> contents, Document& document);

void unpack_document(Document& document);

/// Returns why an image's file cannot be used, or an empty text if it can.
std::string image_problem(const Document& document, std::size_t image);

/// Returns the encoded bytes of an image, stored in `storage` unless they are in a buffer.
Bytes image_bytes(const Document& document, std::size_t image, std::vector<std::byte>& storage);

}  // namespace lippmann::gltf
