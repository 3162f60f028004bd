// JPEG Pleno's folders: {column:03}_{row:03}.ppm, from the top left, with 8 to 16 bits. The reader also accepts other picture
// formats, because data sets are also distributed as PNG.
//
// Samples with b = 8 bits stay 8-bit values. Samples c with more bits become the 16-bit values round(65535 c / (2^b - 1)), from
// which c can be restored exactly.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "core/folder.hpp"
#include "core/text_pattern.hpp"
#include "formats/view_files.hpp"
#include "image/netpbm.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::uint16_t rescaled(std::uint16_t code, int from_highest, int to_highest) {
  const auto from = static_cast<std::uint32_t>(from_highest);
  return static_cast<std::uint16_t>((code * static_cast<std::uint32_t>(to_highest) + from / 2) / from);
}

bool is_ppm_name(const fs::path& path) {
  static const TextPattern ending("\\.ppm", TextPattern::Letters::kEitherCase);
  return ending.match(path.extension().string()).has_value();
}

/// Returns the files row by row, with NumberedFile::numbers = (row, column). The file names state (column, row).
std::vector<NumberedFile> files_by_row(const fs::path& folder) {
  static const TextPattern name("([0-9]{1,4})_([0-9]{1,4})\\.(?:ppm|png|tiff?|bmp|jpe?g|webp|exr)",
                                TextPattern::Letters::kEitherCase);
  std::vector<NumberedFile> files = numbered_files(folder, name, "000_000.ppm, 000_001.ppm, ...");
  for (NumberedFile& file : files) std::swap(file.numbers[0], file.numbers[1]);
  std::ranges::sort(files, {}, &NumberedFile::numbers);
  return files;
}

LightField read_jpeg_pleno(const fs::path& folder, const FormatOptions&) {
  const std::vector<NumberedFile> files = files_by_row(folder);
  const ViewGrid grid = complete_grid(folder, files);
  std::vector<fs::path> by_view(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
    by_view[static_cast<std::size_t>(from_top_left(grid, static_cast<int>(i)))] = files[i].path;
  int highest = 0;
  const auto read_one = [&](const fs::path& path) -> Picture {
    if (!is_ppm_name(path)) return read_picture(path);
    PpmCodes ppm = read_ppm(path);
    if (highest == 0) highest = ppm.highest;
    if (ppm.highest != highest)
      throw Error(path.string(), fmt::format("its largest value is {}", ppm.highest),
                  fmt::format("{}, as in the other views", highest));
    Image16& codes = ppm.codes;
    if (highest == 255) return Image8{codes.width, codes.height, {codes.rgb.begin(), codes.rgb.end()}};
    for (std::uint16_t& code : codes.rgb) code = rescaled(code, highest, 65535);
    return std::move(codes);
  };
  LightField field = read_view_files(by_view, grid, read_one);
  if (highest > 0) field.bits = std::bit_width(static_cast<unsigned>(highest));
  return field;
}

PpmCodes codes_of(const Picture& picture, int bits) {
  PpmCodes ppm{{}, (1 << bits) - 1};
  const auto rescale = [&](const auto& image, int highest) {
    ppm.codes = {image.width, image.height, {image.rgb.begin(), image.rgb.end()}};
    if (highest != ppm.highest)
      for (std::uint16_t& code : ppm.codes.rgb) code = rescaled(code, highest, ppm.highest);
  };
  if (const auto* bytes = std::get_if<Image8>(&picture))
    rescale(*bytes, 255);
  else
    rescale(std::get<Image16>(picture), 65535);
  return ppm;
}

std::vector<fs::path> write_jpeg_pleno(const LightField& field, const fs::path& folder, const FormatOptions& options) {
  const auto name = [&](int view) {
    const int i = from_top_left(field.grid, view);
    return fmt::format("{:03}_{:03}.{}", i % field.grid.columns, i / field.grid.columns, options.png ? "png" : "ppm");
  };
  if (std::holds_alternative<Image>(field.stack))
    throw Error(folder.string(), "JPEG Pleno stores integer samples, but these are floats", "pictures of 8 or 16 bits");
  if (options.png && field.alpha) {  // programs for JPEG Pleno expect three channels
    LightField opaque = field;
    opaque.alpha.reset();
    return write_view_files(opaque, folder, name);
  }
  if (options.png) return write_view_files(field, folder, name);
  const int own_bits = std::holds_alternative<Image8>(field.stack) ? 8 : 16;
  const int bits = options.bits.value_or(field.bits > 0 ? field.bits : own_bits);
  make_folder(folder);
  std::vector<fs::path> written;
  for (int i = 0; i < field.grid.count(); ++i) {
    const int column = i / field.grid.rows, row = i % field.grid.rows;  // names begin with the column
    const int view = from_top_left(field.grid, row * field.grid.columns + column);
    written.push_back(folder / name(view));
    write_ppm(written.back(), codes_of(view_of(field, view), bits));
  }
  return written;
}

}  // namespace

LightFieldFormat jpeg_pleno_format() {
  return {.name = "jpeg-pleno",
          .description = "JPEG Pleno's folder: {column}_{row}.ppm (read: .png too), from the top left; `bits` of its codes",
          .is_folder = true,
          .read = read_jpeg_pleno,
          .write = write_jpeg_pleno,
          .writes = {.bits = true}};
}

}  // namespace lippmann
