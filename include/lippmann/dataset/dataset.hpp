// Makes training data: light fields of random scenes with depth, disparity, normals, motion and ids, as NumPy arrays.
//
// The folder contains:
//   dataset.json      the parameters; a run with other parameters is refused
//   sample_000000/    a sample: views.npy, one array per layer, and sample.json with the cameras, file sizes and checksums
//   manifest.json     the contents of all sample.json files, written when every sample exists
//
// A sample's folder appears when the sample is complete, so an interrupted run continues with the next sample. Samples can be
// divided into units, which different runs render.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

struct DatasetParams {
  /// Names of built-in scenes or scene files. The random scenes contain meshes of these scenes, spheres and boxes.
  std::vector<std::string> scenes = {};
  std::filesystem::path folder = {};
  int count = 1;
  std::uint32_t seed = 0;
  ViewGrid grid{9, 9};
  Vec2i view_size{128, 128};
  int spp = 16;           ///< samples per pixel of path tracing
  std::string unit = {};  ///< part of the samples to make: "3/8", or "1-3,5/8" for several parts; empty: all
};

struct DatasetReport {
  int wanted = 0;  ///< number of samples that DatasetParams::unit selects
  /// kept: samples that were complete before. made: rendered samples. remade: those of them that replace damaged samples.
  int kept = 0, made = 0, remade = 0;
  double seconds = 0.0;  ///< time of rendering and writing
  std::uint64_t bytes = 0;
  bool is_complete = false;  ///< every sample and the manifest exist
};

struct DatasetObserver {
  std::function<void(int to_make, int kept)> planned = {};
  std::function<void(int index, double seconds)> made = {};
};

/// Renders the missing samples and those whose files do not have their recorded sizes and checksums. Stops soon after
/// context.cancelled is set. Throws Error if a scene cannot be read, if the folder holds other data, or if a file cannot be
/// written.
DatasetReport make_dataset(const DatasetParams& params, const Context& context, const DatasetObserver& observer = {});

}  // namespace lippmann
