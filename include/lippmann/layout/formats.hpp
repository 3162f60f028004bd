// The formats of light fields that `convert` reads and writes: one table, of which help, messages and the conversion come.
//
// Each format is one file, NAME_format.cpp, with one reader and one writer.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/display/display.hpp"
#include "lippmann/layout/depth_coding.hpp"
#include "lippmann/layout/interlace.hpp"
#include "lippmann/layout/lens_grid.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/stereo.hpp"

namespace lippmann {

/// Parallel cameras in a regular grid, for files that do not state their cameras. Lengths in mm.
struct StatedCameras {
  double baseline_mm = 0.0;  ///< between neighbouring cameras, before any view is left out
  double focal_length_mm = 0.0;
  double sensor_width_mm = 35.0;   ///< of all pixels of a row, before views are cropped
  double focus_distance_mm = 0.0;  ///< from the cameras to the plane whose points do not move from view to view
};

/// What a format may need beside its name; each uses what concerns it.
struct FormatOptions {
  std::optional<ViewGrid> views = {};  ///< how many views across and up: needed where neither names nor side files say it
  std::optional<ViewGrid> tiles = {};  ///< a quilt's tiles across and up; none: as its name says, or as square as can be
  std::optional<double> aspect = {};  ///< the display's width / height, for a quilt's name; none: the source's or the picture's
  bool with_depth = false;            ///< read it from beside a rendered picture too, where it is (layout/rendered.hpp)
  std::optional<int> bits = {};       ///< how many a code of PPM files has, 1 ... 16; none: as many as the source's
  bool png = false;                   ///< PNG in place of PPM files
  std::optional<Display> display = {};    ///< whose own frame a native picture is
  std::optional<ViewFilter> filter = {};  ///< how native frames take colours from views; none: from the nearest
  std::optional<double> sigma_views = {};
  std::optional<StereoLayout> stereo = {};     ///< how two views lie in one picture; none: as its name says, or side by side
  std::optional<DepthRange> depth_range = {};  ///< greys cover it; none: as the RGB-D picture's side file says, or all there is
  std::optional<bool> even_in_depth = {}, near_black = {};  ///< how they are coded; none: as the side file says (DepthCoding)
  std::optional<StatedCameras> cameras = {};                ///< of files that do not state theirs
  std::optional<PlenopticCalibration> plenoptic = {};       ///< of raw plenoptic pictures; none: as their files state
  /// Applied to each view as its file is read, so that large ones need not be kept. `view`: its number in the grid.
  std::function<Picture(Picture, int view, ViewGrid grid)> fit_view = {};
  std::function<void(std::string_view)> warn = {};  ///< of what pictures say and is not honoured (image/picture_file.hpp)
};

/// Which members of FormatOptions a reader or a writer uses. `filter` includes sigma_views; `depth_coding` is depth_range,
/// even_in_depth and near_black.
struct FormatUses {
  bool views = false, tiles = false, aspect = false, bits = false, display = false, filter = false, stereo = false,
       depth_coding = false, plenoptic = false;
};

/// Paths are those of one light field, of one moment: a picture or a folder.
struct LightFieldFormat {
  std::string_view name;
  std::string_view is;           ///< in one line
  bool is_folder = false;        ///< a folder with one or more files for each view; else one picture
  bool uses_cameras = false;     ///< its writer wants cameras and depth, where they are known
  bool keeps_positions = false;  ///< its files hold the cameras' positions, even without a unit
  bool states_cameras = false;   ///< its files state the cameras: a report.json beside them does not count
  /// Throws Error naming the file or the flag of an option.
  LightField (*read)(const std::filesystem::path& path, const FormatOptions& options) = nullptr;
  /// Returns what was written, pictures first. Folders are made. Throws likewise.
  std::vector<std::filesystem::path> (*write)(const LightField& field, const std::filesystem::path& path,
                                              const FormatOptions& options) = nullptr;
  FormatUses reads = {}, writes = {};
};

LightFieldFormat integral_format();
LightFieldFormat quilt_format();
LightFieldFormat views_format();
LightFieldFormat hci_format();
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

/// All of them, in the order of --help.
const std::vector<LightFieldFormat>& light_field_formats();

/// Throws a usage Error naming `flag` and the known names.
const LightFieldFormat& find_format(std::string_view name, std::string_view flag);

}  // namespace lippmann
