// HCI's older light fields: one HDF5 file with the arrays LF [t][s][y][x][channel] and, for rendered scenes, GT_DEPTH
// [t][s][y][x]. t counts views from the top and s from the right.
//
// Wanner, Meister, Goldluecke: Datasets and benchmarks for densely sampled 4D light fields, VMV 2013. The directions of
// t and s are those of readhci.m in rossimattia/light-field-super-resolution (Rossi, Frossard: Graph-based light field
// super-resolution, MMSP 2017).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/loaded_module.hpp"
#include "core/platform.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "formats/hci_hdf5_cameras.hpp"
#include "formats/hdf5_module.hpp"
#include "formats/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr ModuleName kHdf5Module{"liblippmann_hdf5.so", "lippmann_hdf5_module", "HDF5 files", "lippmann-hdf5"};

const Hdf5Module& hdf5_module() {
  static const auto& loaded = *static_cast<const Hdf5Module*>(load_module(kHdf5Module, kHdf5ModuleVersion));
  return loaded;
}

/// Checks the array of views, and sets the grid and the size of the views.
void set_size(const Hdf5Array& array, LightField& field, const std::string& where) {
  constexpr std::uint64_t kMostViews = 1024, kMostSide = 65536;
  const std::vector<std::uint64_t>& shape = array.shape;
  if (shape.empty()) throw Error(where, "has no array LF", "an HDF5 light field of HCI, with LF and its attributes");
  const bool has_shape = shape.size() == 5 && std::min({shape[0], shape[1], shape[2], shape[3]}) > 0 &&
                         std::max(shape[0], shape[1]) <= kMostViews && std::max(shape[2], shape[3]) <= kMostSide &&
                         (shape[4] == 1 || shape[4] == 3);
  if (!has_shape || array.is_float || (array.item_bytes != 1 && array.item_bytes != 2))
    throw Error(where,
                fmt::format("its array LF has the shape {} of {} of {} bytes", fmt::join(shape, "x"),
                            array.is_float ? "floats" : "other numbers", array.item_bytes),
                "views x views x rows x columns x 1 or 3, of 1 or 2 bytes each");
  field.grid = {static_cast<int>(shape[1]), static_cast<int>(shape[0])};
  field.view_size = {static_cast<int>(shape[3]), static_cast<int>(shape[2])};
  field.aspect = static_cast<double>(field.view_size.x) / field.view_size.y;
}

std::uint64_t t_of(const LightField& field, int view) {
  return static_cast<std::uint64_t>(field.grid.rows - 1 - view / field.grid.columns);
}
std::uint64_t s_of(const LightField& field, int view) {
  return static_cast<std::uint64_t>(field.grid.columns - 1 - view % field.grid.columns);
}

void require_read(const std::string& problem, const std::string& where) {
  if (!problem.empty()) throw Error(where, problem, "an HDF5 light field of HCI");
}

template <class AnyImage>
void read_views(const Hdf5File& file, std::size_t channels, LightField& field, const std::string& where) {
  const Vec2i size = stack_size(field);
  const std::size_t pixels = static_cast<std::size_t>(field.view_size.x) * static_cast<std::size_t>(field.view_size.y);
  AnyImage stack;
  stack.width = size.x, stack.height = size.y;
  stack.rgb.resize(3 * pixels * static_cast<std::size_t>(field.grid.count()));
  for (int view = 0; view < field.grid.count(); ++view) {
    const auto codes = std::span(stack.rgb).subspan(static_cast<std::size_t>(view) * 3 * pixels, 3 * pixels);
    require_read(file.read_codes(t_of(field, view), s_of(field, view), std::as_writable_bytes(codes.first(channels * pixels))),
                 where);
    if (channels == 1)
      for (std::size_t i = pixels; i-- > 0;) std::fill_n(&codes[3 * i], 3, codes[i]);
  }
  field.stack = std::move(stack);
}

void read_depths(const Hdf5File& file, LightField& field, const std::string& where) {
  const Hdf5Array& array = file.header().depth;
  const std::vector<std::uint64_t>& views = file.header().light_field.shape;
  const bool is_number = array.is_float && (array.item_bytes == 4 || array.item_bytes == 8);
  if (array.shape != std::vector(views.begin(), views.end() - 1) || !is_number)
    throw Error(where,
                fmt::format("its array GT_DEPTH has the shape {} of {} of {} bytes", fmt::join(array.shape, "x"),
                            array.is_float ? "floats" : "other numbers", array.item_bytes),
                fmt::format("{} floats of 4 or 8 bytes", fmt::join(views.begin(), views.end() - 1, "x")));
  field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
  const std::size_t pixels = static_cast<std::size_t>(field.view_size.x) * static_cast<std::size_t>(field.view_size.y);
  for (int view = 0; view < field.grid.count(); ++view) {
    const auto depth = std::span(field.depth->data).subspan(static_cast<std::size_t>(view) * pixels, pixels);
    require_read(file.read_depth(t_of(field, view), s_of(field, view), depth), where);
    for (float& z : depth) z = z_of_hdf5_depth(z, field);
  }
}

LightField read_hci_hdf5(const fs::path& path, const FormatOptions& options) {
  const std::string where = path.string();
  require_as_recorded(path);
  require_regular_file(path);  // HDF5 would not report why a file cannot be opened
  const std::unique_ptr<Hdf5File> file = hdf5_module().open(where);
  const Hdf5Header& header = file->header();
  require_read(header.problem, where);
  LightField field;
  set_size(header.light_field, field, where);
  require_stack_fits(where, field.grid.count(), field.view_size,
                     header.light_field.item_bytes + (header.depth.shape.empty() ? 0 : sizeof(float)),
                     platform::available_memory_bytes());
  const std::size_t channels = header.light_field.shape.back();
  if (header.light_field.item_bytes == 1)
    read_views<Image8>(*file, channels, field, where);
  else
    read_views<Image16>(*file, channels, field, where);
  const bool has_cameras = set_hdf5_cameras(header.attributes, field, where);
  if (!has_cameras && options.warn)
    options.warn(where +
                 ": its cameras and depth are unknown: at least one of the attributes dH, dV and focalLength is missing.");
  if (has_cameras && !header.depth.shape.empty()) read_depths(*file, field, where);
  return field;
}

}  // namespace

LightFieldFormat hci_hdf5_format() {
  return {.name = "hci-hdf5",
          .description = "HCI's older light fields, one HDF5 file (lf.h5): LF, GT_DEPTH, attributes; read only",
          .states_cameras = true,
          .read = read_hci_hdf5,
          .written_instead = "hci, the later format of the same benchmark"};
}

}  // namespace lippmann
