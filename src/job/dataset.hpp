// Makes training data: light fields of random scenes with depth, disparity, normals, motion and ids, as NumPy arrays.
//
// FOLDER/dataset.json      the parameters; a run with other parameters is refused
// FOLDER/sample_000000/    views.npy and one array a layer, and sample.json: the cameras, and sizes and checksums of the files
// FOLDER/manifest.json     all sample.json, once every sample is there
//
// A sample's folder appears only when it is complete, so an interrupted run continues with the next sample. Samples are divided
// among units. Two runs of the same unit must not overlap.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "distribute/units.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

struct DatasetParams {
  std::vector<std::string> scenes;  ///< built-in names or files whose meshes become objects, in addition to spheres and boxes
  std::filesystem::path folder;
  int count = 1;
  std::uint32_t seed = 0;
  ViewGrid grid{9, 9};
  Vec2i view_size{128, 128};
  int spp = 16;                     ///< samples per pixel of path tracing
  std::optional<Units> units = {};  ///< nullopt: all samples
};

struct DatasetReport {
  int wanted = 0;            ///< number of samples in this run's units
  int kept = 0, made = 0;    ///< number of samples found complete, and number rendered
  double seconds = 0.0;      ///< time spent rendering and writing
  std::uint64_t bytes = 0;   ///< number of bytes written
  bool is_complete = false;  ///< whether every sample and the manifest exist
};

struct DatasetObserver {
  std::function<void(int to_make, int kept)> planned = {};
  std::function<void(int index, double seconds)> made = {};
};

/// Renders the missing samples. Stops soon after context.cancelled is set; the current sample leaves no files. Throws Error for
/// scenes that cannot be read, for a folder that holds other data, and for files that cannot be written.
DatasetReport make_dataset(const DatasetParams& params, const Context& context, const DatasetObserver& observer = {});

}  // namespace lippmann
