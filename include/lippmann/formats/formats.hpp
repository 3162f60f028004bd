// The light field formats that `convert` reads and writes. Each has one file, NAME_format.cpp, with one reader and one writer.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/display/display.hpp"
#include "lippmann/formats/depth_coding.hpp"
#include "lippmann/layout/interlace.hpp"
#include "lippmann/layout/lens_grid.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/stereo.hpp"

namespace lippmann {

/// Parallel cameras in a regular grid, for files without camera data.
struct StatedCameras {
  double baseline_mm = 0.0;  ///< distance between neighbouring cameras in the file, before views are dropped
  double focal_length_mm = 0.0;
  double sensor_width_mm = 35.0;   ///< width of the part of the sensor that an uncropped view covers
  double focus_distance_mm = 0.0;  ///< distance from the cameras to the plane with zero disparity
};

/// Each format uses only the options that apply to it.
struct FormatOptions {
  /// Views across and up; required if neither the file name nor a side file states them.
  std::optional<ViewGrid> views = {};
  /// A quilt's tiles across and up. None: from the file name, or the arrangement closest to a square.
  std::optional<ViewGrid> tiles = {};
  /// Width / height of the display, for a quilt's file name. None: LightField::aspect.
  std::optional<double> aspect = {};
  bool with_depth = false;                ///< also reads a rendered picture's depth layer, if it exists
  std::optional<int> bits = {};           ///< bits per sample of PPM files, 1 ... 16; none: as in the source
  bool png = false;                       ///< writes PNG instead of PPM files
  bool binary = false;                    ///< the writer of `colmap` writes binary instead of text files
  std::optional<Display> display = {};    ///< for a native picture
  std::optional<ViewFilter> filter = {};  ///< how native frames interpolate between views; none: kNearest
  std::optional<double> sigma_views = {};
  std::optional<StereoLayout> stereo = {};  ///< packing of two views in a picture; none: from the file name, or side by side
  /// Depths at the ends of the grey scale. None: from the side file, or the light field's range.
  std::optional<DepthRange> depth_range = {};
  std::optional<bool> even_in_depth = {}, near_black = {};  ///< See DepthCoding. None: from the side file.
  std::optional<StatedCameras> cameras = {};                ///< added by open_light_field() if the files state none
  std::optional<PlenopticCalibration> plenoptic = {};       ///< calibration of raw plenoptic pictures; none: from their files
  /// Width / height of the pixels of views in folders. None: from a side file or the cameras, or else 1.
  std::optional<double> pixel_aspect = {};
  /// Called for each view right after its file is read, to reduce large originals before all are held in memory. `aspect`:
  /// width / height of the scene area that the picture shows. `view`: the view's number in the grid.
  std::function<Picture(Picture, double aspect, int view, ViewGrid grid)> fit_view = {};
  /// Called with a warning for unsupported metadata of pictures (image/picture_file.hpp).
  std::function<void(std::string_view)> warn = {};
};

/// The options that a reader or a writer uses. `filter` includes sigma_views; `depth_coding` means depth_range, even_in_depth
/// and near_black.
struct FormatUses {
  bool views = false, tiles = false, aspect = false, bits = false, binary = false, display = false, filter = false,
       stereo = false, depth_coding = false, plenoptic = false;
};

/// A format for one light field, in a picture or a folder `path`. kept_data.hpp has the data that each format keeps.
struct LightFieldFormat {
  std::string_view name{};
  std::string_view description{};  ///< one line for users
  bool is_folder = false;          ///< a folder with one or more files per view; otherwise one picture
  bool states_cameras = false;     ///< the files contain cameras, so a report.json beside them is ignored
  /// Throws Error naming the file or the option.
  LightField (*read)(const std::filesystem::path& path, const FormatOptions& options) = nullptr;
  /// Writes a light field and returns the files written, pictures first. Creates folders. Throws Error naming the file or the
  /// option. Null: the format is read only.
  std::vector<std::filesystem::path> (*write)(const LightField& field, const std::filesystem::path& path,
                                              const FormatOptions& options) = nullptr;
  FormatUses reads = {}, writes = {};
  std::string_view written_instead{};  ///< only for read-only formats: the formats to write in their place
};

LightFieldFormat integral_format();
LightFieldFormat quilt_format();
LightFieldFormat views_format();
LightFieldFormat hci_format();
LightFieldFormat hci_hdf5_format();
LightFieldFormat stanford_format();
LightFieldFormat jpeg_pleno_format();
LightFieldFormat eslf_format();
LightFieldFormat plenoptic_format();
LightFieldFormat native_format();
LightFieldFormat miv_format();
LightFieldFormat nerf_format();
LightFieldFormat colmap_format();
LightFieldFormat llff_format();
LightFieldFormat stereo_format();
LightFieldFormat quad_format();
LightFieldFormat rgbd_format();
LightFieldFormat cvkit_format();
LightFieldFormat lytro_format();

/// Returns all formats, in the order of --help.
const std::vector<LightFieldFormat>& light_field_formats();

/// Returns the names of the formats that can be written, in the order of --help.
const std::vector<std::string_view>& output_format_names();

/// Returns the format of this name. Throws a usage Error naming `flag` and listing the known names.
const LightFieldFormat& find_format(std::string_view name, std::string_view flag);

/// Returns the format of this name. Also throws a usage Error naming `flag` if the format is read only.
const LightFieldFormat& find_output_format(std::string_view name, std::string_view flag);

}  // namespace lippmann
