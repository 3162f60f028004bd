// Folders of the Stanford light field archive: out_{row}_{column}_{y}_{x}.png, with row 0 at the top and column 0 at
// the left. y and x are the position of the camera, in no stated unit; y counts downwards like the rows. (Some names in
// the archive have another _ at the end.) If positions are unknown, y and x are the row and the column.
//
// If the cameras are known, parameters.cfg is also written and read (formats/hci_parameters.hpp). Its baseline is the
// mean distance between neighbouring cameras, in the unit of the positions.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "core/text_pattern.hpp"
#include "formats/hci_parameters.hpp"
#include "formats/stated_cameras.hpp"
#include "formats/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::optional<double> finite_number(const std::string& text) {
  double number = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// The texts of y and x in a file's name; none if the name does not have both.
std::optional<std::pair<std::string, std::string>> position_texts(const fs::path& file) {
  static const TextPattern name("out_[0-9]+_[0-9]+_([^_]+)_([^_]+)_?", TextPattern::Letters::kEitherCase);
  const std::optional<PatternMatch> found = name.match(file.stem().string());
  if (!found) return std::nullopt;
  return std::pair(found->groups[1], found->groups[2]);
}

/// The position in a file's name, x right and y up; none if the name has no position.
std::optional<Vec2d> stanford_position(const fs::path& file) {
  const auto texts = position_texts(file);
  if (!texts) return std::nullopt;
  const std::optional<double> y = finite_number(texts->first), x = finite_number(texts->second);
  if (!y || !x) return std::nullopt;
  return Vec2d(*x, -*y);
}

Error position_error(const fs::path& file) {
  const auto texts = position_texts(file);
  if (!texts)
    return {file.string(), "its name has no y and x, unlike other names",
            "out_{row}_{column}_{y}_{x}, or no y and x in all names"};
  const bool is_y = !finite_number(texts->first);
  return {file.string(), fmt::format("{} in its name is {}", is_y ? "y" : "x", is_y ? texts->first : texts->second),
          "a number, or no y and x in all names"};
}

/// Returns none if no name has a position.
std::optional<std::vector<Vec2d>> stanford_positions(const std::vector<fs::path>& by_view) {
  std::vector<Vec2d> positions;
  const fs::path* without = nullptr;
  for (const fs::path& file : by_view) {
    if (const std::optional<Vec2d> position = stanford_position(file))
      positions.push_back(*position);
    else if (!without)
      without = &file;
  }
  if (positions.empty()) return std::nullopt;
  if (without) throw position_error(*without);
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
  const std::optional<std::vector<Vec2d>> positions = stanford_positions(by_view);
  LightField field = read_view_files(by_view, grid, options, [&](int view, Vec2i size) {
    if (parameters) require_size(*parameters, by_view[static_cast<std::size_t>(view)], size);
  });
  field.positions = positions;
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
