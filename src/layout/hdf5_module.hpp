// The interface to a module (liblippmann_hdf5.so) that contains libhdf5. The module is loaded when the first HDF5 file is read,
// because nothing else needs the library. Private to src/layout.
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
  bool is_float = false;  ///< true: floats; false: integers
};

/// The contents of a light field's file, except the samples.
struct Hdf5Header {
  Hdf5Array light_field, depth;  ///< the arrays LF and GT_DEPTH of the root group
  /// Attributes of the root group that describe cameras, by name. Attributes that the file lacks are not in the map.
  std::map<std::string, double> attributes = {};
  std::string problem = {};  ///< error message; empty on success
};

class Hdf5File {
 public:
  virtual ~Hdf5File() = default;
  virtual const Hdf5Header& header() const = 0;
  /// Read one view, with the array indices t and s. read_codes() reads its samples from LF, in the machine's byte order;
  /// read_depth() reads its depth from GT_DEPTH. The span must be as large as a view. Return an error message; empty on
  /// success.
  virtual std::string read_codes(std::uint64_t t, std::uint64_t s, std::span<std::byte> codes) const = 0;
  virtual std::string read_depth(std::uint64_t t, std::uint64_t s, std::span<float> depth) const = 0;
};

class Hdf5Module {
 public:
  virtual ~Hdf5Module() = default;
  virtual std::unique_ptr<Hdf5File> open(const std::string& path) const = 0;
};

/// Version of this header. Increment it with every change, because a module of another version is rejected.
inline constexpr int kHdf5ModuleVersion = 1;

}  // namespace lippmann
