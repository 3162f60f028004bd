// The interface of liblippmann_hdf5.so, which contains all code that needs libhdf5. This module is loaded when the first
// HDF5 file is read. Private to src/formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct Hdf5Array {
  std::vector<std::uint64_t> shape = {};  ///< empty: the file has no such array
  std::size_t item_bytes = 0;
  bool is_float = false;  ///< false: integers
};

struct Hdf5Header {
  Hdf5Array light_field, depth;  ///< the arrays LF and GT_DEPTH of the root group
  /// Attributes of the root group that describe cameras, by name.
  std::map<std::string, double> attributes = {};
  std::string problem = {};  ///< error message; empty on success
};

class Hdf5File {
 public:
  virtual ~Hdf5File() = default;
  virtual const Hdf5Header& header() const = 0;
  /// Read the view with the array indices t and s. read_codes() reads its samples from LF, in the machine's byte order, and
  /// read_depth() its depth from GT_DEPTH. The span must be as large as a view. Return an error message; empty on success.
  virtual std::string read_codes(std::uint64_t t, std::uint64_t s, std::span<std::byte> codes) const = 0;
  virtual std::string read_depth(std::uint64_t t, std::uint64_t s, std::span<float> depth) const = 0;
};

class Hdf5Module {
 public:
  virtual ~Hdf5Module() = default;
  virtual std::unique_ptr<Hdf5File> open(const std::string& path) const = 0;
};

/// Increment this number with every change of this header. Modules with another number are rejected.
inline constexpr int kHdf5ModuleVersion = 1;

}  // namespace lippmann
