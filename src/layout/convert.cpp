#include "layout/convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "image/picture_file.hpp"
#include "layout/quilt_name.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Views one below the other, and what is known of them.
struct Stack {
  Picture picture;
  ViewGrid grid;
  Vec2i view_size{0, 0};
  std::optional<ViewGrid> tiles;  ///< of the quilt they came from
  double aspect = 1.0;            ///< of the picture they came from, or of the display if its name said so
};

std::vector<unsigned char>& samples_of(Image8& image) { return image.rgb; }
std::vector<std::uint16_t>& samples_of(Image16& image) { return image.rgb; }
std::vector<float>& samples_of(Image& image) { return image.data; }

Vec2i size_of(const Picture& picture) {
  return std::visit([](const auto& image) { return Vec2i(image.width, image.height); }, picture);
}

/// A black picture of the same kind of samples.
Picture blank(const Picture& like, Vec2i size) {
  return std::visit(
      [&](const auto& image) {
        auto copy = std::remove_cvref_t<decltype(image)>();
        copy.width = size.x, copy.height = size.y;
        samples_of(copy).resize(3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        return Picture(std::move(copy));
      },
      like);
}

/// to[to_pixel[i]] = from[from_pixel[i]]; an empty list counts up.
void move_pixels(Picture& from, const std::vector<std::uint32_t>& from_pixel, Picture& to,
                 const std::vector<std::uint32_t>& to_pixel) {
  std::visit(
      [&](auto& source) {
        auto& target = std::get<std::remove_cvref_t<decltype(source)>>(to);
        const std::size_t count = std::max(from_pixel.size(), to_pixel.size());
        for (std::size_t i = 0; i < count; ++i) {
          const std::size_t s = from_pixel.empty() ? i : from_pixel[i], t = to_pixel.empty() ? i : to_pixel[i];
          std::copy_n(samples_of(source).begin() + 3 * static_cast<std::ptrdiff_t>(s), 3,
                      samples_of(target).begin() + 3 * static_cast<std::ptrdiff_t>(t));
        }
      },
      from);
}

Stack unpack(const fs::path& path, const ViewLayout& layout) {
  Picture picture = read_picture(path);
  const Vec2i size = size_of(picture), view = view_size(layout, size, path.string());
  Stack stack{
      blank(picture, {view.x, view.y * layout.grid.count()}), layout.grid, view, {}, static_cast<double>(size.x) / size.y};
  move_pixels(picture, pixels_of_views(layout, view, size), stack.picture, {});
  return stack;
}

Stack read_integral(const fs::path& path, const ConvertParams& params) {
  if (!params.views)
    throw usage_error("--views", "an integral image does not say how many pixels lie below its lenses", "CxR, such as 8x1");
  return unpack(path, {LayoutKind::kIntegral, *params.views, {}});
}

Stack read_quilt(const fs::path& path, const ConvertParams& params) {
  const std::optional<QuiltName> name = parse_quilt_name(path);
  if (!name && !params.tiles)
    throw usage_error("--quilt", "the name of " + path.string() + " does not say how many tiles it has", "CxR, such as 8x6");
  const ViewGrid tiles = params.tiles.value_or(name ? name->tiles : ViewGrid{});
  const ViewGrid grid = params.views.value_or(ViewGrid{tiles.count(), 1});
  if (grid.count() != tiles.count())
    throw usage_error("--views", fmt::format("{}x{} views are not as many as {}x{} tiles", grid.columns, grid.rows,
                                             tiles.columns, tiles.rows));
  Stack stack = unpack(path, {LayoutKind::kQuilt, grid, tiles});
  stack.tiles = tiles;
  stack.aspect = name ? name->aspect : static_cast<double>(stack.view_size.x) / stack.view_size.y;
  return stack;
}

/// By the number in their names.
std::map<int, fs::path> numbered_views(const fs::path& folder) {
  std::map<int, fs::path> files;
  std::error_code problem;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, problem)) {
    int number = 0;
    const std::string name = entry.path().filename().string();
    if (std::sscanf(name.c_str(), "view_%d.", &number) != 1) continue;
    if (!files.emplace(number, entry.path()).second)
      throw Error(folder.string(), fmt::format("it has two pictures for view {}", number));
  }
  if (problem)
    throw Error(folder.string(), "it cannot be listed (" + problem.message() + ")",
                "a folder of view_000.png, view_001.png, ...");
  if (files.empty()) throw Error(folder.string(), "there are no views in it", "view_000.png, view_001.png, ...");
  const int first = files.begin()->first, count = static_cast<int>(files.size());
  for (const auto& [number, path] : files)
    if (number >= first + count || first > 1)
      throw Error(folder.string(), "views are missing", fmt::format("all from 0 to {}", files.rbegin()->first));
  return files;
}

Stack read_views(const fs::path& folder, const ConvertParams& params) {
  const std::map<int, fs::path> files = numbered_views(folder);
  Stack stack;
  stack.grid = params.views.value_or(ViewGrid{static_cast<int>(files.size()), 1});
  if (static_cast<std::size_t>(stack.grid.count()) != files.size())
    throw usage_error("--views", fmt::format("{}x{} are not as many as the {} views in {}", stack.grid.columns, stack.grid.rows,
                                             files.size(), folder.string()));
  std::uint32_t next = 0;
  for (const auto& [number, path] : files) {
    Picture view = read_picture(path);
    if (next == 0) {
      stack.view_size = size_of(view);
      stack.aspect = static_cast<double>(stack.view_size.x) / stack.view_size.y;
      stack.picture = blank(view, {stack.view_size.x, stack.view_size.y * stack.grid.count()});
    }
    if (size_of(view) != stack.view_size || view.index() != stack.picture.index())
      throw Error(path.string(), "it is not of the size and kind of the other views",
                  fmt::format("{}x{} pixels as in {}", stack.view_size.x, stack.view_size.y,
                              files.begin()->second.filename().string()));
    std::vector<std::uint32_t> to(static_cast<std::size_t>(stack.view_size.x) * static_cast<std::size_t>(stack.view_size.y));
    for (std::uint32_t& pixel : to) pixel = next++;
    move_pixels(view, {}, stack.picture, to);
  }
  return stack;
}

/// The factor of `count` nearest above its root: 8 x 6 of 48.
ViewGrid squarest(int count) {
  int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  while (count % columns != 0) ++columns;
  return {columns, count / columns};
}

ViewGrid tiles_for(const Stack& stack, const ConvertParams& params) {
  const int count = stack.grid.count();
  ViewGrid tiles = stack.grid.rows > 1 ? stack.grid : squarest(count);
  if (stack.tiles) tiles = *stack.tiles;
  if (params.tiles && params.from != LayoutKind::kQuilt) tiles = *params.tiles;
  if (tiles.count() != count)
    throw usage_error("--quilt", fmt::format("{}x{} tiles are not as many as {} views", tiles.columns, tiles.rows, count));
  return tiles;
}

void make_folder(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) throw Error(folder.string(), "the folder cannot be made (" + problem.message() + ")");
}

void write_views(Stack& stack, const fs::path& folder, Converted& result) {
  make_folder(folder);
  const char* ending = std::holds_alternative<Image>(stack.picture) ? "exr" : "png";
  const std::size_t pixels = static_cast<std::size_t>(stack.view_size.x) * static_cast<std::size_t>(stack.view_size.y);
  std::vector<std::uint32_t> from(pixels);
  for (int view = 0; view < stack.grid.count(); ++view) {
    for (std::size_t i = 0; i < pixels; ++i) from[i] = static_cast<std::uint32_t>(static_cast<std::size_t>(view) * pixels + i);
    Picture picture = blank(stack.picture, stack.view_size);
    move_pixels(stack.picture, from, picture, {});
    result.written.push_back(folder / fmt::format("view_{:03}.{}", view, ending));
    write_picture(result.written.back(), picture);
  }
}

void write_packed(Stack& stack, const ViewLayout& layout, const fs::path& path, Converted& result) {
  const Vec2i size = picture_size(layout, stack.view_size);
  Picture picture = blank(stack.picture, size);
  move_pixels(stack.picture, {}, picture, pixels_of_views(layout, stack.view_size, size));
  write_picture(path, picture);
  result.written.push_back(path);
}

void write(Stack& stack, const fs::path& out, const ConvertParams& params, Converted& result) {
  result.views = stack.grid, result.view_size = stack.view_size;
  if (params.to == LayoutKind::kStack) return write_views(stack, out, result);
  if (params.to == LayoutKind::kIntegral) return write_packed(stack, {LayoutKind::kIntegral, stack.grid, {}}, out, result);
  const ViewGrid tiles = tiles_for(stack, params);
  const fs::path named = with_quilt_name(out, {tiles, params.aspect.value_or(stack.aspect)});
  write_packed(stack, {LayoutKind::kQuilt, stack.grid, tiles}, named, result);
}

Stack read(const fs::path& in, const ConvertParams& params) {
  if (params.from == LayoutKind::kStack) return read_views(in, params);
  return params.from == LayoutKind::kIntegral ? read_integral(in, params) : read_quilt(in, params);
}

std::vector<fs::path> frames_in(const fs::path& folder) {
  std::vector<fs::path> frames;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with("frame_") && entry.is_regular_file()) frames.push_back(entry.path());
  std::sort(frames.begin(), frames.end());
  if (frames.empty()) throw Error(folder.string(), "there are no frames in it", "frame_0000.png, frame_0001.png, ...");
  return frames;
}

}  // namespace

Converted convert(const fs::path& in, const fs::path& out, const ConvertParams& params) {
  Converted result;
  std::error_code ignored;
  if (params.from == LayoutKind::kStack || !fs::is_directory(in, ignored)) {
    Stack stack = read(in, params);
    write(stack, out, params, result);
    return result;
  }
  make_folder(out);
  for (const fs::path& frame : frames_in(in)) {
    Stack stack = read(frame, params);
    write(stack, out / (params.to == LayoutKind::kStack ? frame.stem() : frame.filename()), params, result);
  }
  return result;
}

}  // namespace lippmann
