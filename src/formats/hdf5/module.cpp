// Reads arrays with libhdf5. Arrays with data outside of the file, which HDF5 allows, are not read. The module exports
// only its entry function.
#include <hdf5.h>

#include <array>
#include <utility>

#include "formats/hdf5_module.hpp"

namespace lippmann {
namespace {

template <auto close>
class Handle {
 public:
  explicit Handle(hid_t id = H5I_INVALID_HID) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close(id_);
  }
  explicit operator bool() const { return id_ >= 0; }
  hid_t operator*() const { return id_; }

 private:
  hid_t id_;
};
using FileHandle = Handle<H5Fclose>;
using Dataset = Handle<H5Dclose>;
using Space = Handle<H5Sclose>;
using Type = Handle<H5Tclose>;
using Properties = Handle<H5Pclose>;
using Attribute = Handle<H5Aclose>;

constexpr std::array kAttributes{"dH", "dV", "focalLength", "shift"};

std::vector<std::uint64_t> shape_of(const Space& space) {
  const int dimensions = H5Sget_simple_extent_ndims(*space);
  if (dimensions < 1) return {};
  std::vector<hsize_t> shape(static_cast<std::size_t>(dimensions));
  H5Sget_simple_extent_dims(*space, shape.data(), nullptr);
  return {shape.begin(), shape.end()};
}

/// Opens an array of the file. An array that is a link to another file counts as missing.
Dataset open_array(const FileHandle& file, const char* name, std::string& problem) {
  H5L_info_t link;
  if (H5Lexists(*file, name, H5P_DEFAULT) <= 0 || H5Lget_info(*file, name, &link, H5P_DEFAULT) < 0 ||
      link.type != H5L_TYPE_HARD)
    return Dataset();
  Dataset array(H5Dopen2(*file, name, H5P_DEFAULT));
  const Properties properties(array ? H5Dget_create_plist(*array) : H5I_INVALID_HID);
  if (!properties) {
    problem = std::string(name) + " is no array";
    return Dataset();
  }
  if (H5Pget_layout(*properties) == H5D_VIRTUAL || H5Pget_external_count(*properties) != 0) {
    problem = "the numbers of " + std::string(name) + " lie in another file";
    return Dataset();
  }
  return array;
}

Hdf5Array described(const Dataset& array) {
  if (!array) return {};
  const Space space(H5Dget_space(*array));
  const Type type(H5Dget_type(*array));
  const H5T_class_t kind = H5Tget_class(*type);
  const bool is_number = kind == H5T_INTEGER || kind == H5T_FLOAT;
  return {shape_of(space), is_number ? H5Tget_size(*type) : 0, kind == H5T_FLOAT};
}

/// Reads a number. Some files store it as an array with one element.
void read_attribute(const FileHandle& file, const char* name, Hdf5Header& header) {
  constexpr hssize_t kMostNumbers = 64;
  if (H5Aexists(*file, name) <= 0) return;
  const Attribute attribute(H5Aopen(*file, name, H5P_DEFAULT));
  const Space space(H5Aget_space(*attribute));
  const Type type(H5Aget_type(*attribute));
  const H5T_class_t kind = H5Tget_class(*type);
  const hssize_t count = H5Sget_simple_extent_npoints(*space);
  std::array<double, kMostNumbers> values{};
  const bool is_number = (kind == H5T_INTEGER || kind == H5T_FLOAT) && H5Tget_size(*type) <= sizeof(double);
  if (!is_number || count < 1 || count > kMostNumbers || H5Aread(*attribute, H5T_NATIVE_DOUBLE, values.data()) < 0)
    header.problem = "its attribute " + std::string(name) + " is no number";
  else
    header.attributes[name] = values[0];
}

class OpenedFile : public Hdf5File {
 public:
  explicit OpenedFile(const std::string& path) : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    if (!file_) {
      header_.problem = "is no HDF5 file, or is damaged";
      return;
    }
    light_field_ = open_array(file_, "LF", header_.problem);
    depth_ = open_array(file_, "GT_DEPTH", header_.problem);
    header_.light_field = described(light_field_);
    header_.depth = described(depth_);
    for (const char* name : kAttributes) read_attribute(file_, name, header_);
  }

  const Hdf5Header& header() const override { return header_; }

  std::string read_codes(std::uint64_t t, std::uint64_t s, std::span<std::byte> codes) const override {
    const hid_t type = header_.light_field.item_bytes == 1 ? H5T_NATIVE_UINT8 : H5T_NATIVE_UINT16;
    return read(light_field_, header_.light_field, {t, s}, type, codes.data());
  }

  std::string read_depth(std::uint64_t t, std::uint64_t s, std::span<float> depth) const override {
    return read(depth_, header_.depth, {t, s}, H5T_NATIVE_FLOAT, depth.data());
  }

 private:
  static std::string read(const Dataset& dataset, const Hdf5Array& array, std::array<std::uint64_t, 2> view, hid_t type,
                          void* to) {
    std::vector<hsize_t> start(array.shape.size(), 0), count(array.shape.begin(), array.shape.end());
    hsize_t numbers = 1;
    for (std::size_t i = 0; i < count.size(); ++i) {
      if (i < view.size()) start[i] = view[i], count[i] = 1;
      numbers *= count[i];
    }
    const Space in_file(H5Dget_space(*dataset)), in_memory(H5Screate_simple(1, &numbers, nullptr));
    if (H5Sselect_hyperslab(*in_file, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0 ||
        H5Dread(*dataset, type, *in_memory, *in_file, H5P_DEFAULT, to) < 0)
      return "its numbers are damaged, or compressed in a way that libhdf5 does not read";
    return {};
  }

  FileHandle file_;
  Dataset light_field_, depth_;
  Hdf5Header header_;
};

class Libhdf5 : public Hdf5Module {
 public:
  Libhdf5() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are returned, not printed
    H5PLset_loading_state(0);                     // never loads plugins
  }
  std::unique_ptr<Hdf5File> open(const std::string& path) const override { return std::make_unique<OpenedFile>(path); }
};

}  // namespace
}  // namespace lippmann

extern "C" __attribute__((visibility("default"))) const void* lippmann_hdf5_module(int version) {
  static const lippmann::Libhdf5 module;
  return version == lippmann::kHdf5ModuleVersion ? &module : nullptr;
}
