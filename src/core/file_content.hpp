// Guesses what a file holds from its first bytes, for the message of a reader that cannot read it.
//
// Use it where a reader has found that the bytes are not its format:
//
//   const FileContent content = describe_content(bytes);
//   throw Error(where, "cannot be read as glTF: it is " + content.what,
//               content.remedy.empty() ? "a .glb or .gltf file" : content.remedy);
//
// A file with a remedy stands in for the file that the user meant: it is empty, a Git LFS pointer or a web page. No reader of
// text takes those either, so it may ask stand_in_for_file() before it parses anything.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace lippmann {

struct FileContent {
  std::string what;    ///< with its article: "a PNG picture", "text that begins 'hello'", "binary data of an unknown kind"
  std::string remedy;  ///< how to get the file that was meant; empty unless `what` stands in for it
};

/// `begin` is the whole file or at least its first 512 bytes; empty only for an empty file. `what` is printable.
FileContent describe_content(std::span<const std::byte> begin);

/// The same, but only for a file that the user can replace by the one meant.
std::optional<FileContent> stand_in_for_file(std::span<const std::byte> begin);

}  // namespace lippmann
