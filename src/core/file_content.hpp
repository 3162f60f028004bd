// Guesses the contents of a file from its first bytes, for error messages.
//
// Example, for bytes that are not in the format of a reader:
//
//   const FileContent content = describe_content(bytes);
//   throw Error(where, "cannot be read as glTF: it is " + content.what,
//               content.advice.empty() ? "a .glb or .gltf file" : content.advice);
//
// If `advice` is not empty, the file is a placeholder for the intended file: an empty file, a Git LFS pointer or a web page.
// Parsers of text formats would report a placeholder as a syntax error. Call stand_in_for_file() before parsing to report the
// placeholder instead.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace lippmann {

struct FileContent {
  std::string what;    ///< description: "a PNG picture", "text that begins 'hello'", "binary data of an unknown kind"
  std::string advice;  ///< how to get the intended file; empty unless the file is a placeholder
};

/// Describes a file. `begin` contains the whole file or at least its first 512 bytes. The result's `what` is printable.
FileContent describe_content(std::span<const std::byte> begin);

/// Describes a file that is a placeholder; returns nothing for other files.
std::optional<FileContent> stand_in_for_file(std::span<const std::byte> begin);

}  // namespace lippmann
