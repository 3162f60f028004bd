// The interface to libhdf5: a module (liblippmann_hdf5.so) that is loaded when the first HDF5 file is read. Nothing else needs
// the library. Private to src/layout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lippmann {

/// Shape and type of an array.
struct Hdf5Array {
  std::vector<std::uint64_t> shape = {};  ///< empty: the file has no such array
  std::size_t item_bytes = 0;
  bool is_float = false;  ///< else integers
};

/// The contents of a light field's file, without the samples.
struct Hdf5Header {
  Hdf5Array light_field, depth;                   ///< the arrays LF and GT_DEPTH of the root
  std::map<std::string, double> attributes = {};  ///< those of the root that cameras need, as far as they are there
  std::string problem = {};                       ///< error message; empty on success
};

class Hdf5File {
 public:
  virtual ~Hdf5File() = default;
  virtual const Hdf5Header& header() const = 0;
  /// Reads the view (t, s) of LF, in the byte order of the machine, or of GT_DEPTH. The span is as large as a view. Returns an
  /// error message; empty on success.
  virtual std::string read_codes(std::uint64_t t, std::uint64_t s, std::span<std::byte> codes) const = 0;
  virtual std::string read_depth(std::uint64_t t, std::uint64_t s, std::span<float> depth) const = 0;
};

class Hdf5Module {
 public:
  virtual ~Hdf5Module() = default;
  virtual std::unique_ptr<Hdf5File> open(const std::string& path) const = 0;
};

/// Increment this with every change of this header: a module of another version is rejected.
inline constexpr int kHdf5ModuleVersion = 1;

}  // namespace lippmann
