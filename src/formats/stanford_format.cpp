// Folders of the Stanford light field archive: out_{row}_{column}_{y}_{x}.png, with row 0 at the top and column 0 at
// the left. y and x are the position of the camera, in no stated unit; y counts downwards like the rows. (Some names in
// the archive have another _ at the end.) If positions are unknown, y and x are the row and the column.
//
// If the cameras are known, parameters.cfg is also written and read (formats/hci_parameters.hpp). Its baseline is the
// mean distance between neighbouring cameras, in the unit of the positions.
#include <fmt/format.h>

#include <charconv>

#include "core/text_pattern.hpp"
#include "formats/hci_parameters.hpp"
#include "formats/stated_cameras.hpp"
#include "formats/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// The position in a file's name, x right and y up; none if the name has no position.
std::optional<Vec2d> stanford_position(const fs::path& file) {
  static const TextPattern name("out_[0-9]+_[0-9]+_(-?[0-9.]{1,40})_(-?[0-9.]{1,40})_?", TextPattern::Letters::kEitherCase);
  const std::optional<PatternMatch> found = name.match(file.stem().string());
  if (!found) return std::nullopt;
  Vec2d position;
  for (const int axis : {0, 1}) {
    const std::string& digits = found->groups[static_cast<std::size_t>(2 - axis)];
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), position[axis]);
    if (problem != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  }
  return Vec2d(position.x, -position.y);
}

std::optional<std::vector<Vec2d>> stanford_positions(const std::vector<fs::path>& by_view) {
  std::vector<Vec2d> positions;
  for (const fs::path& file : by_view) {
    const std::optional<Vec2d> position = stanford_position(file);
    if (!position) return std::nullopt;
    positions.push_back(*position);
  }
  return positions;
}

LightField read_stanford(const fs::path& folder, const FormatOptions& options) {
  static const TextPattern name("out_([0-9]{1,5})_([0-9]{1,5})(?:_.*)?\\.(?:png|jpe?g|exr|ppm|tiff?|bmp|webp)",
                                TextPattern::Letters::kEitherCase);
  const std::vector<NumberedFile> files = numbered_files(folder, name, "out_00_00_<y>_<x>.png, ...");
  const ViewGrid grid = complete_grid(folder, files);
  std::vector<fs::path> by_view(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
    by_view[static_cast<std::size_t>(from_top_left(grid, static_cast<int>(i)))] = files[i].path;
  const std::optional<HciParameters> parameters = read_hci_parameters(folder);
  LightField field = read_view_files(by_view, grid, options, [&](int view, Vec2i size) {
    if (parameters) require_size(*parameters, by_view[static_cast<std::size_t>(view)], size);
  });
  field.positions = stanford_positions(by_view);
  if (options.fit_view) return field;  // views that fit_view has resized do not match the cameras
  if (parameters) field.hci = parameters->notes;
  if (parameters && grid == ViewGrid{parameters->columns, parameters->rows})
    field.cameras =
        grid.count() == 1 ? hci_cameras(*parameters) : cameras_as_stated(stated_cameras(*parameters), field, folder.string());
  return field;
}

/// Returns the values for parameters.cfg; none if the cameras are unknown or if parameters.cfg cannot
/// state them, for example because their pixels are not square.
std::optional<HciParameters> parameters_of(const LightField& field, const fs::path& folder) {
  if (!field.cameras) return std::nullopt;
  try {
    return mean_hci_parameters(field, folder.string());
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Six decimals as in the archive, or more if they are needed to restore the same number.
std::string position_text(double position) {
  const std::string archived = fmt::format("{:.6f}", position + 0.0), shortest = fmt::format("{}", position + 0.0);
  double read = 0.0;
  std::from_chars(archived.data(), archived.data() + archived.size(), read);
  return read == position || shortest.find('e') != std::string::npos ? archived : shortest;
}

std::vector<fs::path> write_stanford(const LightField& field, const fs::path& folder, const FormatOptions&) {
  const char* ending = exact_ending(field.stack);
  std::vector<fs::path> written = write_view_files(field, folder, [&](int view) {
    const int row = field.grid.rows - 1 - view / field.grid.columns, column = view % field.grid.columns;
    const auto index = static_cast<std::size_t>(view);
    if (field.positions) {
      const Vec2d kept = (*field.positions)[index];
      return fmt::format("out_{:02}_{:02}_{}_{}.{}", row, column, position_text(-kept.y), position_text(kept.x), ending);
    }
    const Vec2d eye = field.cameras ? field.cameras->eyes_mm[index] : Vec2d(column, -row);
    return fmt::format("out_{:02}_{:02}_{:.6f}_{:.6f}.{}", row, column, -eye.y + 0.0, eye.x, ending);
  });
  std::optional<HciParameters> parameters = parameters_of(field, folder);
  if (!parameters) return written;
  written.push_back(write_hci_parameters(folder, *parameters));
  return written;
}

}  // namespace

LightFieldFormat stanford_format() {
  return {.name = "stanford",
          .description = "the Stanford archive's folder: out_{row}_{column}_{y}_{x}.png, from the top left",
          .is_folder = true,
          .read = read_stanford,
          .write = write_stanford};
}

}  // namespace lippmann
