// A glTF document that has passed all checks of form, with the bytes that it refers to.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/gltf.hpp"
#include "scene/gltf/container.hpp"
#include "scene/gltf/report.hpp"
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

struct ImageSource {
  std::string name;
  std::string uri;  ///< empty: in a buffer view
  int buffer_view = -1;
};

/// A buffer view that meshoptimizer has packed (meshopt.hpp).
struct PackedView {
  int buffer = 0;
  std::size_t byte_offset = 0, byte_length = 0;
  std::size_t byte_stride = 0, count = 0;  ///< size of an element that comes out, and how many come out
  std::string mode, filter;
};

/// Holds: every index in `model` refers to something that exists, every buffer view lies within its buffer, every accessor
/// within its buffer views. `model` has neither buffers nor images; they are here.
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
  tinygltf::Model model;
  std::vector<Bytes> buffers;
  std::vector<ImageSource> images;
  std::vector<std::optional<PackedView>> packed_views;  ///< by buffer view of the file

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
