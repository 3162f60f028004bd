// Writes arrays as NumPy files (.npy, format 1.0), which programs can map into memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

/// Returns the bytes of a file. dtype: <f4, |u1, ...; bytes: the samples in C order, matching `shape`.
std::vector<std::byte> npy_file(const std::string& dtype, const std::vector<int>& shape, std::span<const std::byte> bytes);

}  // namespace lippmann
