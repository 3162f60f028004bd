// The container of Lytro's cameras, .lfp and .lfr: a JSON document, and blocks that it refers to by their SHA-1.
//
// A file is a row of sections. Each begins with 16 bytes: 0x89 "LFP", "LFM" or "LFC", 0D 0A 1A 0A, a version, and the length of
// its data, both 32 bits, the highest byte first. If the length is above 0, the name of the data follows ("sha1-" and 40
// digits) in a field of 80 bytes, then the data, then zeros up to a multiple of 16 bytes. LFP is the file's own header, LFM the
// document, LFC a block. Checksums are taken as names: they are not computed.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct LfpSection {
  std::string kind;  ///< LFM or LFC
  std::string name;  ///< "sha1-..."
  std::span<const std::byte> data;
};

bool is_lfp(std::span<const std::byte> file);

/// All sections with data, in the order of the file, of whose bytes they are parts. Throws Error naming `where`.
std::vector<LfpSection> lfp_sections(std::span<const std::byte> file, const std::string& where);

/// Throws Error naming `where` if there is no such section.
const LfpSection& lfp_section(const std::vector<LfpSection>& sections, const std::string& name, const std::string& where);

}  // namespace lippmann
