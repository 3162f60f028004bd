#include "formats/posed_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <sstream>
#include <string_view>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/npy.hpp"
#include "core/printable.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "formats/picture_folder.hpp"
#include "formats/stated_cameras.hpp"
#include "formats/view_files.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Completes the camera: computes the values that the camera file lacks from the size of the picture.
void complete(PosedPicture& picture, Vec2i size) {
  PosedCamera& camera = picture.camera;
  for (const int axis : {0, 1}) {
    if (camera.size[axis] == 0) camera.size[axis] = size[axis];
    if (std::isnan(camera.principal_px[axis])) camera.principal_px[axis] = 0.5 * size[axis];
  }
  if (camera.size != size)
    throw Error(picture.entry,
                fmt::format("its camera has {}x{} pixels, but the picture {} has {}x{}", camera.size.x, camera.size.y,
                            shown(picture.picture), size.x, size.y),
                "a camera and a picture of the same size");
  if (camera.focal_px.x == 0.0) camera.focal_px.x = 0.5 * size.x / std::tan(0.5 * picture.angle_x);
  if (camera.focal_px.y == 0.0) camera.focal_px.y = camera.focal_px.x;
}

std::vector<PosedCamera> cameras_of(const std::vector<PosedPicture>& pictures) {
  std::vector<PosedCamera> cameras;
  for (const PosedPicture& picture : pictures) cameras.push_back(picture.camera);
  return cameras;
}

/// Returns one value per picture, or none if a picture has no value.
template <class T>
std::optional<std::vector<T>> values_of(const std::vector<PosedPicture>& pictures, std::optional<T> PosedPicture::*member) {
  std::vector<T> values;
  for (const PosedPicture& picture : pictures) {
    if (!(picture.*member)) return std::nullopt;
    values.push_back(*(picture.*member));
  }
  return values;
}

/// Converts points from the world to the display frame of `cameras`. `first`: the first of these cameras, in the world.
void move_to_display(const PosedCamera& first, const ViewCameras& cameras, std::vector<CloudPoint>& points) {
  const Vec3d eye(cameras.eyes_mm.front(), cameras.distance_mm);
  for (CloudPoint& point : points)
    point.position_mm = glm::transpose(first.rotation) * (point.position_mm - first.position_mm) + eye;
}

template <class T>
void reorder(std::vector<T>& values, const std::vector<std::size_t>& order) {
  std::vector<T> sorted;
  for (const std::size_t i : order) sorted.push_back(std::move(values[i]));
  values = std::move(sorted);
}

/// Sorts views row by row upwards, each row from left to right. Returns the number of rows.
int sort_as_rows(ViewCameras& cameras, std::vector<PosedPicture>& pictures) {
  // Maximum difference in height within a row, as a fraction of the extent of all eyes, because rows of calibrated
  // cameras are not exactly level.
  constexpr double kSameRow = 1e-4;
  std::vector<std::size_t> order(pictures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto eye = [&](std::size_t i) { return cameras.eyes_mm[i]; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return eye(a).y < eye(b).y; });
  double extent = 0.0;
  for (const Vec2d& e : cameras.eyes_mm) extent = std::max(extent, glm::distance(e, cameras.eyes_mm.front()));
  int rows = 0;
  for (auto row = order.begin(); row != order.end(); ++rows) {
    const double y = eye(*row).y;
    const auto end = std::find_if(row, order.end(), [&](std::size_t i) { return eye(i).y > y + kSameRow * extent; });
    std::stable_sort(row, end, [&](std::size_t a, std::size_t b) { return eye(a).x < eye(b).x; });
    row = end;
  }
  reorder(pictures, order);
  reorder(cameras.eyes_mm, order);
  return rows;
}

ViewGrid posed_grid(std::vector<PosedPicture>& pictures, std::optional<ViewCameras>& cameras, const FormatOptions& options,
                    const fs::path& file) {
  const int count = static_cast<int>(pictures.size());
  const int rows = cameras ? sort_as_rows(*cameras, pictures) : 1;
  ViewGrid grid{count, 1};
  if (count % rows == 0 && rows > 1 && common_baseline_mm(*cameras, {count / rows, rows})) grid = {count / rows, rows};
  if (options.views && options.views->count() != count)
    throw usage_error("views", fmt::format("{}x{} does not match the {} pictures in {}", options.views->columns,
                                           options.views->rows, count, file.string()));
  if (cameras && !options.views) warn_of_missing_cameras(cameras->eyes_mm, file.string(), options);
  return options.views.value_or(grid);
}

Image read_depth_codes(const fs::path& path, Vec2i size) {
  const Picture picture = read_picture(path);
  const auto* codes = std::get_if<Image16>(&picture);
  if (!codes || size_of(picture) != size)
    throw Error(path.string(), codes ? "does not match its picture" : "does not have 16 bits",
                fmt::format("a 16-bit PNG of {}x{} pixels", size.x, size.y));
  Image depth(size.x, size.y, 1);
  for (std::size_t i = 0; i < depth.data.size(); ++i) depth.data[i] = codes->rgb[3 * i];
  return depth;
}

Image read_planar_depth(const fs::path& path, Vec2i size) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 32;
  if (path.extension() == ".png") return read_depth_codes(path, size);
  const NpyArray array = parse_npy(read_recorded_bytes(path, kMaxBytes, "a .npy file"), path.string());
  const std::vector<std::size_t> shape{static_cast<std::size_t>(size.y), static_cast<std::size_t>(size.x)};
  if (array.shape != shape)
    throw Error(path.string(), "does not match its picture", fmt::format("{} rows of {} floats", size.y, size.x));
  Image depth(size.x, size.y, 1);
  std::transform(array.values.begin(), array.values.end(), depth.data.begin(), [](double d) { return static_cast<float>(d); });
  return depth;
}

/// Returns why the depth of a picture cannot be read; empty if it can be.
std::string depth_problem(const fs::path& folder, const PosedPicture& picture) {
  if (picture.depth.empty()) return "has no depth file";
  if (!picture.depth.ends_with(".npy") && !picture.depth.ends_with(".png"))
    return fmt::format("its depth file {} is neither .npy nor .png", shown(picture.depth));
  return is_regular_file_there(folder / picture.depth) ? "" : fmt::format("its depth file {} is missing", shown(picture.depth));
}

/// Reads the depth of all views. If only some have depth, calls leave_out_depth().
void read_depths(const fs::path& folder, const std::vector<PosedPicture>& pictures, const FormatOptions& options,
                 LightField& field) {
  if (std::all_of(pictures.begin(), pictures.end(), [](const PosedPicture& p) { return p.depth.empty(); })) return;
  for (const PosedPicture& picture : pictures)
    if (const std::string problem = depth_problem(folder, picture); !problem.empty())
      return leave_out_depth(field, options, picture.entry + ": " + problem);
  field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
  const double plane = field.cameras ? field.cameras->distance_mm : 0.0;
  std::ptrdiff_t undefined = 0;
  std::string first_undefined;
  for (int view = 0; view < field.grid.count(); ++view) {
    const fs::path file = folder / pictures[static_cast<std::size_t>(view)].depth;
    Image depth = read_planar_depth(file, field.view_size);
    const auto nan = std::ranges::find_if(depth.data, [](float d) { return std::isnan(d); });
    if (undefined == 0 && nan != depth.data.end()) {
      const std::ptrdiff_t pixel = nan - depth.data.begin();
      first_undefined = fmt::format("{}: pixel ({}, {})", file.string(), pixel % depth.width, pixel / depth.width);
    }
    undefined += std::count_if(nan, depth.data.end(), [](float d) { return std::isnan(d); });
    for (float& d : depth.data)
      d = d > 0.0f && std::isfinite(d) ? static_cast<float>(plane - static_cast<double>(d)) : -kInfinity;
    set_depth(field, view, depth);
  }
  if (undefined > 0 && options.warn)
    options.warn(
        fmt::format("{}: depth is NaN; such pixels, {} in all views, are read as no surface", first_undefined, undefined));
}

unsigned char code_of(const Picture& stack, std::size_t sample) {
  if (const auto* bytes = std::get_if<Image8>(&stack)) return bytes->rgb[sample];
  return static_cast<unsigned char>(std::get<Image16>(stack).rgb[sample] >> 8);
}

void write_array(const fs::path& path, const Image& image) {
  const std::vector<std::size_t> shape{static_cast<std::size_t>(image.height), static_cast<std::size_t>(image.width)};
  write_file_atomically(path, encode_npy(std::span<const float>(image.data), shape));
}

LightField field_of_picture(const fs::path& folder, const PosedPicture& picture, bool with_colours) {
  LightField field;
  field.grid = {1, 1}, field.view_size = picture.camera.size;
  if (with_colours) field.stack = read_picture(folder / picture.picture);
  read_depths(folder, {picture}, {}, field);
  return field;
}

bool is_there(double depth_mm) { return depth_mm > 0.0 && std::isfinite(depth_mm); }

}  // namespace

void check_inner_path(const std::string& path, const std::string& where) {
  constexpr std::size_t kLongest = 1000;
  const fs::path inner(path);
  const bool leaves = std::any_of(inner.begin(), inner.end(), [](const fs::path& part) { return part == ".."; });
  if (path.empty() || path.size() > kLongest || inner.is_absolute() || leaves || path.find('\0') != std::string::npos)
    throw Error(where, "its path is " + shown(path), "a path inside the folder");
}

fs::path path_of_picture(const fs::path& folder, const PosedPicture& picture) {
  for (const char* ending : {"", ".png", ".jpg", ".exr"})
    if (const fs::path path = folder / (picture.picture + ending); is_regular_file_there(path)) return path;
  throw Error(picture.entry, fmt::format("the picture {} is missing", shown(picture.picture)),
              "a picture in " + folder.string());
}

std::string posed_picture_name(int view, int count, const char* ending) {
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(count - 1).size());
  return fmt::format("images/{:0{}}.{}", view, digits, ending);
}

std::string posed_depth_name(int view, int count) {
  const fs::path picture = posed_picture_name(view, count, "npy");
  return "depth/" + picture.filename().string();
}

std::string ray_length_name(const std::string& depth_name) {
  return depth_name.substr(0, depth_name.size() - std::string(".npy").size()) + "_ray.npy";
}

LightField read_posed_pictures(const fs::path& folder, PosedSet set, const FormatOptions& options) {
  std::vector<PosedPicture>& pictures = set.pictures;
  if (pictures.empty()) throw Error(set.file.string(), "lists no pictures", "at least one");
  const Vec2i size = size_of(read_picture(path_of_picture(folder, pictures.front())));
  std::set<std::string> names;
  for (PosedPicture& picture : pictures) {
    complete(picture, size);
    if (!names.insert(picture.picture).second)
      throw Error(picture.entry, fmt::format("repeats the picture {}", shown(picture.picture)), "each picture once");
  }
  std::optional<ViewCameras> cameras = shared_plane(cameras_of(pictures));
  if (cameras) move_to_display(pictures.front().camera, *cameras, set.points);
  const ViewGrid grid = posed_grid(pictures, cameras, options, set.file);
  std::vector<fs::path> by_view;
  for (const PosedPicture& picture : pictures) by_view.push_back(path_of_picture(folder, picture));
  LightField field = read_view_files(by_view, grid, with_pixel_aspect(options, pictures.front().camera.focal_px));
  if (!cameras) field.poses = cameras_of(pictures);
  if (options.fit_view) return field;  // views that fit_view has resized do not match the sizes of the cameras
  field.cameras = std::move(cameras);
  field.points = std::move(set.points);
  field.depth_bounds_mm = values_of(pictures, &PosedPicture::depth_bounds_mm);
  field.splits = values_of(pictures, &PosedPicture::split);
  field.times = values_of(pictures, &PosedPicture::time);
  read_depths(folder, pictures, options, field);
  return field;
}

std::vector<PosedPicture> pictures_of_split(const std::vector<PosedPicture>& pictures, Split split) {
  std::vector<PosedPicture> part;
  for (const PosedPicture& picture : pictures)
    if (picture.split == split) part.emplace_back(picture).split.reset();
  return part;
}

std::string held_out_names(const std::vector<PosedPicture>& pictures) {
  std::string names;
  for (const PosedPicture& picture : pictures)
    if (picture.split != Split::kTraining) names += fs::path(picture.picture).filename().string() + '\n';
  return names;
}

void read_held_out_names(const fs::path& file, std::vector<PosedPicture>& pictures,
                         const std::function<void(std::string_view)>& warn) {
  constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20;
  if (!is_regular_file_there(file)) return;
  SplitList held_out{Split::kTest};
  std::istringstream lines(read_recorded_text(file, kMaxBytes));
  for (std::string name; std::getline(lines, name);) {
    if (name.ends_with('\r')) name.pop_back();
    if (!name.empty()) held_out.names.push_back(name);
  }
  set_splits({held_out}, pictures, file.string(), warn);
}

void write_held_out_names(const fs::path& file, const std::vector<PosedPicture>& pictures) {
  const std::string names = held_out_names(pictures);
  write_file_atomically(file, std::as_bytes(std::span(names)));
}

std::vector<PosedPicture> listed_pictures(const LightField& field, const fs::path& folder) {
  const std::vector<PosedCamera> cameras = posed_cameras(field, folder.string());
  std::vector<PosedPicture> pictures;
  for (int view = 0; view < field.grid.count(); ++view) {
    const auto at = static_cast<std::size_t>(view);
    PosedPicture& picture = pictures.emplace_back();
    picture.picture = posed_picture_name(view, field.grid.count(), exact_ending(field.stack));
    picture.camera = cameras[at];
    if (field.splits) picture.split = (*field.splits)[at];
    if (field.times) picture.time = (*field.times)[at];
  }
  return pictures;
}

void set_splits(const std::vector<SplitList>& lists, std::vector<PosedPicture>& pictures, const std::string& where,
                const std::function<void(std::string_view)>& warn) {
  const auto plain = [](const std::string& name) { return fs::path(name).lexically_normal().generic_string(); };
  std::map<std::string, Split> splits;
  for (const SplitList& list : lists)
    for (const std::string& name : list.names) splits.emplace(plain(name), list.split);
  std::set<std::string> unknown;
  for (const auto& [name, split] : splits) unknown.insert(name);
  for (const PosedPicture& picture : pictures) unknown.erase(plain(picture.picture));
  if (!unknown.empty() && warn)
    warn(fmt::format("{}: left out, because the data set has no such pictures: {}", where,
                     listed_names({unknown.begin(), unknown.end()})));
  if (unknown.size() == splits.size()) return;
  for (PosedPicture& picture : pictures) {
    const auto found = splits.find(plain(picture.picture));
    picture.split = found == splits.end() ? Split::kTraining : found->second;
  }
}

std::vector<fs::path> write_posed_pictures(const LightField& field, const fs::path& folder) {
  make_folder(folder / "images");
  const char* ending = exact_ending(field.stack);
  return write_view_files(field, folder, [&](int view) { return posed_picture_name(view, field.grid.count(), ending); });
}

Image ray_lengths(const Image& planar_depth, const PosedCamera& camera) {
  Image lengths = planar_depth;
  for (int y = 0; y < lengths.height; ++y)
    for (int x = 0; x < lengths.width; ++x) {
      const Vec2d slope = (Vec2d(x + 0.5, y + 0.5) - camera.principal_px) / camera.focal_px;
      float& length = *lengths.pixel(x, y);
      length = static_cast<float>(length * std::sqrt(1.0 + glm::dot(slope, slope)));
    }
  return lengths;
}

std::vector<CloudPoint> point_cloud(const LightField& field, const std::vector<PosedCamera>& cameras, std::size_t most) {
  std::vector<CloudPoint> cloud;
  if (!field.depth) return cloud;
  const bool is_light = std::holds_alternative<Image>(field.stack);
  const Picture codes = is_light ? Picture(to_codes(std::get<Image>(field.stack), Encoding::kSrgb)) : Picture();
  const Picture& colours = is_light ? codes : field.stack;
  const double pixels = static_cast<double>(field.depth->data.size());
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / static_cast<double>(most)))));
  for (int view = 0; view < field.grid.count(); ++view)
    for (int y = step / 2; y < field.view_size.y; y += step)
      for (int x = step / 2; x < field.view_size.x; x += step) {
        const int row = view * field.view_size.y + y;
        const double depth_mm = planar_depth_mm(field, *field.depth->pixel(x, row));
        if (!is_there(depth_mm)) continue;
        const auto at =
            3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(field.view_size.x) + static_cast<std::size_t>(x));
        cloud.push_back({unprojected(cameras[static_cast<std::size_t>(view)], Vec2d(x + 0.5, y + 0.5), depth_mm),
                         {code_of(colours, at), code_of(colours, at + 1), code_of(colours, at + 2)}});
      }
  return cloud;
}

std::vector<fs::path> write_posed_depth(const LightField& field, int view, const PosedCamera& camera, const fs::path& folder,
                                        const std::string& name, double scale) {
  Image depth = depth_of(field, view);
  for (float& z : depth.data) {
    const double mm = planar_depth_mm(field, z);
    z = is_there(mm) ? static_cast<float>(scale * mm) : 0.0f;
  }
  const std::vector<fs::path> paths{folder / name, folder / ray_length_name(name)};
  write_array(paths[0], depth);
  write_array(paths[1], ray_lengths(depth, camera));
  return paths;
}

std::vector<fs::path> write_posed_view(const LightField& field, const fs::path& folder, const ViewOfSet& view) {
  make_folder(folder / "images");
  std::vector<fs::path> written{folder / posed_picture_name(view.number, view.count, exact_ending(field.stack))};
  write_picture(written.front(), field.stack);
  if (!field.depth) return written;
  make_folder(folder / "depth");
  for (fs::path& path : write_posed_depth(field, 0, posed_cameras(field, folder.string()).front(), folder,
                                          posed_depth_name(view.number, view.count), view.depth_scale))
    written.push_back(std::move(path));
  return written;
}

std::vector<CloudPoint> cloud_of_pictures(const fs::path& folder, const std::vector<PosedPicture>& pictures, std::size_t most) {
  std::vector<CloudPoint> cloud;
  for (const PosedPicture& picture : pictures) {
    const std::vector<CloudPoint> seen =
        point_cloud(field_of_picture(folder, picture, true), {picture.camera}, most / pictures.size() + 1);
    cloud.insert(cloud.end(), seen.begin(), seen.end());
  }
  return cloud;
}

Vec2d depth_bounds_of_pictures(const fs::path& folder, const std::vector<PosedPicture>& pictures) {
  Vec2d bounds(INFINITY, 0.0);
  for (const PosedPicture& picture : pictures) {
    const Vec2d own = depth_bounds_mm(field_of_picture(folder, picture, false));
    bounds = {std::min(bounds.x, own.x), std::max(bounds.y, own.y)};
  }
  return bounds;
}

Vec2d depth_bounds_mm(const LightField& field) {
  Vec2d bounds(INFINITY, 0.0);
  if (field.depth)
    for (const float z : field.depth->data)
      if (const double mm = planar_depth_mm(field, z); is_there(mm)) bounds = {std::min(bounds.x, mm), std::max(bounds.y, mm)};
  return bounds.y > 0.0 ? bounds : Vec2d(100.0, 100e3);
}

}  // namespace lippmann
