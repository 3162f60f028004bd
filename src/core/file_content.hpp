// Guesses the contents of a file from its first bytes, for error messages.
//
// Example, for bytes that are not in the format of a reader:
//
//   const FileContent content = describe_content(bytes);
//   throw Error(where, "cannot be read as glTF: it is " + content.what,
//               content.advice.empty() ? "a .glb or .gltf file" : content.advice);
//
// If `advice` is not empty, the file is a placeholder for the intended file: an empty file, a Git LFS pointer or a web page.
// Call stand_in_for_file() before parsing to report the placeholder instead of a syntax error.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace lippmann {

struct FileContent {
  std::string what;
  std::string advice;  ///< how to get the intended file; empty unless the file is a placeholder
};

/// `begin` contains the whole file or at least its first 512 bytes. The result's `what` is printable.
FileContent describe_content(std::span<const std::byte> begin);

std::optional<FileContent> stand_in_for_file(std::span<const std::byte> begin);

}  // namespace lippmann
