// A glTF document that has passed all checks of form, with the bytes that it refers to.
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

/// Counts down what a file may still make us allocate.
class Budget {
 public:
  explicit Budget(std::uint64_t bytes) : limit_(bytes), left_(bytes) {}
  /// Throws Error at `element` if `count` things of `size` bytes are too much.
  void spend(std::uint64_t count, std::uint64_t size, std::string_view element, const Report& report);

 private:
  std::uint64_t limit_, left_;
};

struct BufferView {
  int buffer = 0;
  std::size_t byte_offset = 0, byte_length = 0;
  std::size_t byte_stride = 0;  ///< 0: elements follow one another without gaps
};

/// As glTF numbers them.
enum class ComponentType : int { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt = 5125, kFloat };

struct Sparse {
  std::size_t count = 0;
  int index_view = 0, value_view = 0;
  std::size_t index_offset = 0, value_offset = 0;
  ComponentType index_type = ComponentType::kUnsignedInt;
};

struct Accessor {
  int buffer_view = -1;  ///< -1: zeros
  std::size_t byte_offset = 0, count = 0;
  ComponentType component_type = ComponentType::kFloat;
  bool normalized = false;
  int components = 1;   ///< of an element
  int matrix_side = 0;  ///< rows and columns where elements are matrices, else 0
  std::optional<Sparse> sparse;
};

/// A buffer view that meshoptimizer has packed (meshopt.hpp).
struct PackedView {
  int buffer = 0;
  std::size_t byte_offset = 0, byte_length = 0;
  std::size_t byte_stride = 0, count = 0;  ///< size of an element that comes out, and how many come out
  std::string mode, filter;
};

/// Holds: every index in `root` refers to something that exists, every buffer view lies within its buffer, every accessor
/// within its buffer views.
struct Document {
  Document(const std::filesystem::path& path, const LoadOptions& options, const Context& context, const GltfLimits& file_limits)
      : folders{path.parent_path(), options.asset_root},
        texture_bytes(options.texture_bytes),
        limits(file_limits),
        report(path.string(), context),
        unpacked(limits.unpacked_bytes) {}

  SideFolders folders;
  std::uint64_t texture_bytes;  ///< as LoadOptions has it
  GltfLimits limits;
  Report report;
  Budget unpacked;
  Value root;
  std::vector<Bytes> buffers;
  std::vector<BufferView> buffer_views;                 ///< the file's, then those of what was packed
  std::vector<std::optional<PackedView>> packed_views;  ///< by buffer view of the file
  std::vector<Accessor> accessors;

  /// An element of one of the root's arrays.
  Value at(std::string_view array, int index) const { return root[array].at(static_cast<std::size_t>(index)); }
  const Accessor& accessor(int index) const { return accessors[static_cast<std::size_t>(index)]; }
  /// The bytes of a buffer view.
  Bytes view(int index) const;

  std::shared_ptr<const nlohmann::json> json;  ///< what `root` refers to
  std::vector<std::byte> contents;             ///< the bytes of the scene's file
  std::vector<std::vector<std::byte>> loaded;  ///< what `buffers` views outside of `contents`
};

/// Fills a document from a file's contents, without unpacking anything: its byte ranges are not checked yet, and packed
/// elements are not there. Warns about extensions that are not read.
void read_document(std::vector<std::byte> contents, Document& document);

/// The rest: decompresses what is packed, and checks byte ranges.
void unpack_document(Document& document);

/// Why the file of an image cannot be used: it is missing, or not one that may be opened; empty: nothing speaks against it.
std::string image_problem(const Document& document, std::size_t image);

/// The encoded bytes of an image; `storage` keeps them where they are not in a buffer.
Bytes image_bytes(const Document& document, std::size_t image, std::vector<std::byte>& storage);

}  // namespace lippmann::gltf
