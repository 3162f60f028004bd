// Reads the container format of Lytro cameras, .lfp and .lfr: a JSON document, and blocks that the document refers to by SHA-1.
//
// A file is a sequence of sections: LFP is the file header, LFM the document, LFC a block. A section consists of
//   16 bytes    0x89 "LFP", "LFM" or "LFC"; 0D 0A 1A 0A; the version and the data's length as 32-bit big-endian numbers
//   80 bytes    the name of the data ("sha1-" and 40 digits), if the length is above 0
//   data        followed by zeros up to a multiple of 16 bytes
// The checksums are used only as names and are not verified.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct LfpSection {
  std::string kind;  ///< "LFM" or "LFC"
  std::string name;  ///< "sha1-" and 40 digits
  std::span<const std::byte> data;
};

bool is_lfp(std::span<const std::byte> file);

/// Returns all sections with data, in file order, as views into `file`. Throws Error naming `where`.
std::vector<LfpSection> lfp_sections(std::span<const std::byte> file, const std::string& where);

/// Throws Error naming `where` if the section is missing.
const LfpSection& lfp_section(const std::vector<LfpSection>& sections, const std::string& name, const std::string& where);

}  // namespace lippmann
