// Arrays as files of NumPy (.npy, format 1.0), which programs map into memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

/// A whole file. dtype: <f4, |u1, ...; bytes: the samples in C order, those of `shape`.
std::vector<std::byte> npy_file(const std::string& dtype, const std::vector<int>& shape, std::span<const std::byte> bytes);

}  // namespace lippmann
