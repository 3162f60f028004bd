// Based on: COLMAP's documentation, "Output Format"; Schoenberger, Frahm: Structure-from-motion revisited, CVPR 2016.
#include "formats/colmap_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

#include "core/folder_entries.hpp"
#include "core/printable.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kMostPosed = 65536;
constexpr double kMostPlace = 1e9;

struct ColmapModel {
  std::string_view name;
  /// Number of all parameters, and of focal lengths. The parameters are focal lengths, principal point and distortion.
  std::size_t params, focals;
};

/// COLMAP's camera models by id. Models with 0 focal lengths are not pinholes.
constexpr ColmapModel kColmapModels[] = {{"SIMPLE_PINHOLE", 3, 1}, {"PINHOLE", 4, 2}, {"SIMPLE_RADIAL", 4, 1},
                                         {"RADIAL", 5, 1},         {"OPENCV", 8, 2},  {"OPENCV_FISHEYE", 8, 0},
                                         {"FULL_OPENCV", 12, 2}};

/// The values of a camera or pose in a text or binary file.
class ColmapSource {
 public:
  virtual ~ColmapSource() = default;
  virtual double number(const char* what, double most) = 0;
  virtual std::uint64_t whole(const char* what, std::uint64_t most) = 0;
  [[noreturn]] virtual void reject(const std::string& problem, const std::string& accepted) const = 0;
};

class ColmapLine final : public ColmapSource {
 public:
  ColmapLine(std::string_view text, std::string where) : text_(text), where_(std::move(where)) {}

  std::string_view word(const char* what) {
    text_.remove_prefix(std::min(text_.find_first_not_of(" \t"), text_.size()));
    if (text_.empty()) reject(fmt::format("ends before its {}", what), what);
    const std::string_view word = text_.substr(0, text_.find_first_of(" \t"));
    text_.remove_prefix(word.size());
    return word;
  }
  double number(const char* what, double most) override {
    const std::string_view text = word(what);
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || !(std::abs(value) <= most))
      reject(fmt::format("its {} is {}", what, shown(text)), fmt::format("a number up to {:g}", most));
    return value;
  }
  std::uint64_t whole(const char* what, std::uint64_t most) override {
    const std::string_view text = word(what);
    std::uint64_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || value > most)
      reject(fmt::format("its {} is {}", what, shown(text)), fmt::format("a whole number up to {}", most));
    return value;
  }
  /// Returns the rest of the line, trimmed.
  std::string remaining() const {
    const std::size_t begin = std::min(text_.find_first_not_of(" \t"), text_.size());
    const std::size_t end = text_.find_last_not_of(" \t\r");
    return end == std::string_view::npos || end < begin ? std::string() : std::string(text_.substr(begin, end + 1 - begin));
  }
  [[noreturn]] void reject(const std::string& problem, const std::string& accepted) const override {
    throw Error(where_, problem, accepted);
  }

 private:
  std::string_view text_;
  std::string where_;
};

class ColmapBytes final : public ColmapSource {
 public:
  ColmapBytes(std::span<const std::byte> bytes, const std::string& where) : bytes_(bytes), where_(where) {}

  void enter(std::string entry) { entry_ = std::move(entry); }
  template <class T>
  T next() {
    T value;
    if (bytes_.size() < sizeof value) reject("the file is truncated", "a whole file");
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_ = bytes_.subspan(sizeof value);
    return value;
  }
  double number(const char* what, double most) override {
    const auto value = next<double>();
    if (!(std::abs(value) <= most)) reject(fmt::format("its {} is {}", what, value), fmt::format("a number up to {:g}", most));
    return value;
  }
  std::uint64_t whole(const char* what, std::uint64_t most) override { return checked(what, next<std::uint64_t>(), most); }
  std::uint64_t whole32(const char* what, std::uint64_t most) { return checked(what, next<std::uint32_t>(), most); }
  std::string name() {
    std::string text;
    for (char c = next<char>(); c != '\0'; c = next<char>()) text += c;
    return text;
  }
  void skip(std::uint64_t count, std::size_t size) {
    if (count > bytes_.size() / size) reject("the file is truncated", "a whole file");
    bytes_ = bytes_.subspan(static_cast<std::size_t>(count) * size);
  }
  [[noreturn]] void reject(const std::string& problem, const std::string& accepted) const override {
    throw Error(where_ + (entry_.empty() ? "" : ": " + entry_), problem, accepted);
  }

 private:
  std::uint64_t checked(const char* what, std::uint64_t value, std::uint64_t most) const {
    if (value > most) reject(fmt::format("its {} is {}", what, value), fmt::format("a whole number up to {}", most));
    return value;
  }

  std::span<const std::byte> bytes_;
  std::string where_, entry_;
};

constexpr std::uint64_t kAnyId = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kAnyPoint = std::numeric_limits<std::uint64_t>::max();

PosedCamera camera_of_model(const ColmapModel& model, ColmapSource& source) {
  constexpr std::uint64_t kMostSide = 65536;
  constexpr double kMostFocal = 1e9;
  if (model.focals == 0)
    source.reject(fmt::format("its model is {}", model.name), "PINHOLE, SIMPLE_PINHOLE, or a model without distortion");
  PosedCamera camera;
  const auto side = [&](const char* what) {
    const std::uint64_t pixels = source.whole(what, kMostSide);
    if (pixels == 0) source.reject(fmt::format("its {} is 0", what), fmt::format("1 to {} pixels", kMostSide));
    return static_cast<int>(pixels);
  };
  const auto focal_length = [&] {
    const double pixels = source.number("focal length", kMostFocal);
    if (!(pixels > 0.0)) source.reject(fmt::format("its focal length is {}", pixels), "a number of pixels above 0");
    return pixels;
  };
  camera.size.x = side("width");
  camera.size.y = side("height");
  camera.focal_px.x = focal_length();
  camera.focal_px.y = model.focals == 2 ? focal_length() : camera.focal_px.x;
  camera.principal_px.x = source.number("principal point", kMostPlace);
  camera.principal_px.y = source.number("principal point", kMostPlace);
  for (std::size_t i = model.focals + 2; i < model.params; ++i)
    if (source.number("distortion", kMostPlace) != 0.0)
      source.reject("its lens has distortion", "pictures written by COLMAP's image_undistorter");
  return camera;
}

/// Converts to the axes of PosedCamera.
void read_pose(ColmapSource& source, PosedCamera& camera) {
  double q[4], t[3];
  for (double& value : q) value = source.number("rotation", 1e3);
  for (double& value : t) value = source.number("translation", kMostPlace);
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(std::abs(length - 1.0) < 1e-2)) source.reject("its rotation is not a unit quaternion", "four numbers w, x, y, z");
  const glm::dmat3 camera_from_world = glm::mat3_cast(glm::dquat(q[0] / length, q[1] / length, q[2] / length, q[3] / length));
  const glm::dmat3 world_from_camera = glm::transpose(camera_from_world);
  camera.rotation = {world_from_camera[0], -world_from_camera[1], -world_from_camera[2]};
  camera.position_mm = world_from_camera * (-kMmPerUnit * Vec3d(t[0], t[1], t[2]));
}

PosedCamera camera_with(const ColmapCameras& cameras, std::uint64_t id, const ColmapSource& source) {
  const auto found = cameras.find(static_cast<unsigned>(id));
  if (found == cameras.end()) source.reject(fmt::format("its camera {} is missing", id), "a camera of the model");
  return found->second;
}

void add_picture(PosedPicture picture, std::vector<PosedPicture>& pictures, const ColmapSource& source) {
  check_inner_path(picture.picture, picture.entry);
  if (pictures.size() >= kMostPosed) source.reject("has too many images", fmt::format("at most {} images", kMostPosed));
  pictures.push_back(std::move(picture));
}

void sort_by_name(std::vector<PosedPicture>& pictures) {
  std::stable_sort(pictures.begin(), pictures.end(),
                   [](const PosedPicture& a, const PosedPicture& b) { return natural_less(a.picture, b.picture); });
}

void add_camera(ColmapCameras& cameras, std::uint64_t id, const PosedCamera& camera, const ColmapSource& source) {
  if (cameras.size() >= kMostPosed) source.reject("has too many cameras", fmt::format("at most {} cameras", kMostPosed));
  if (!cameras.emplace(static_cast<unsigned>(id), camera).second)
    source.reject(fmt::format("repeats the number {}", id), "distinct numbers");
}

template <class Visit>
void visit_lines(const std::string& text, const Visit& visit) {
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line(text.data() + begin, end - begin);
    begin = end + 1, ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!line.starts_with('#')) visit(line, number);
  }
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t") == std::string_view::npos; }

}  // namespace

ColmapCameras parse_colmap_cameras(const std::string& text, const std::string& where) {
  ColmapCameras cameras;
  visit_lines(text, [&](std::string_view line, std::size_t number) {
    if (is_blank(line)) return;
    ColmapLine source(line, fmt::format("{}:{}", where, number));
    const std::uint64_t id = source.whole("camera number", kAnyId);
    const std::string_view name = source.word("model");
    const auto* model = std::find_if(std::begin(kColmapModels), std::end(kColmapModels),
                                     [&](const ColmapModel& known) { return known.name == name; });
    if (model == std::end(kColmapModels)) source.reject("its model is " + shown(name), "PINHOLE or SIMPLE_PINHOLE");
    add_camera(cameras, id, camera_of_model(*model, source), source);
  });
  return cameras;
}

ColmapCameras parse_colmap_cameras(std::span<const std::byte> binary, const std::string& where) {
  ColmapCameras cameras;
  ColmapBytes source(binary, where);
  const std::uint64_t count = source.whole("number of cameras", kMostPosed);
  for (std::uint64_t i = 0; i < count; ++i) {
    source.enter(fmt::format("camera {}", i + 1));
    const std::uint64_t id = source.whole32("camera number", kAnyId);
    const std::uint64_t model = source.whole32("model", std::size(kColmapModels) - 1);
    add_camera(cameras, id, camera_of_model(kColmapModels[model], source), source);
  }
  return cameras;
}

std::vector<PosedPicture> parse_colmap_images(const std::string& text, const ColmapCameras& cameras, const std::string& where) {
  std::vector<PosedPicture> pictures;
  bool is_points = false;  // the next line lists the points of the previous picture, and may be empty
  visit_lines(text, [&](std::string_view line, std::size_t number) {
    if (is_points) {
      is_points = false;
      return;
    }
    if (is_blank(line)) return;
    ColmapLine source(line, fmt::format("{}:{}", where, number));
    source.whole("image number", kAnyId);
    PosedPicture picture;
    read_pose(source, picture.camera);
    const PosedCamera posed = picture.camera;
    picture.camera = camera_with(cameras, source.whole("camera number", kAnyId), source);
    picture.camera.rotation = posed.rotation, picture.camera.position_mm = posed.position_mm;
    picture.picture = source.remaining();
    picture.entry = fmt::format("{}:{}", where, number);
    add_picture(std::move(picture), pictures, source);
    is_points = true;
  });
  sort_by_name(pictures);
  return pictures;
}

std::vector<PosedPicture> parse_colmap_images(std::span<const std::byte> binary, const ColmapCameras& cameras,
                                              const std::string& where) {
  constexpr std::size_t kPointBytes = 24;  // bytes of a point: x, y, and its id
  std::vector<PosedPicture> pictures;
  ColmapBytes source(binary, where);
  const std::uint64_t count = source.whole("number of images", kMostPosed);
  for (std::uint64_t i = 0; i < count; ++i) {
    PosedPicture picture;
    const std::string entry = fmt::format("image {}", i + 1);
    picture.entry = fmt::format("{}: {}", where, entry);
    source.enter(entry);
    source.whole32("image number", kAnyId);
    read_pose(source, picture.camera);
    const PosedCamera posed = picture.camera;
    picture.camera = camera_with(cameras, source.whole32("camera number", kAnyId), source);
    picture.camera.rotation = posed.rotation, picture.camera.position_mm = posed.position_mm;
    picture.picture = source.name();
    source.skip(source.whole("number of points", kAnyPoint), kPointBytes);
    add_picture(std::move(picture), pictures, source);
  }
  sort_by_name(pictures);
  return pictures;
}

ColmapPoints parse_colmap_points(const std::string& text, const std::string& where) {
  ColmapPoints read;
  visit_lines(text, [&](std::string_view line, std::size_t number) {
    if (is_blank(line)) return;
    ColmapLine source(line, fmt::format("{}:{}", where, number));
    source.whole("point number", kAnyPoint);
    CloudPoint point;
    for (const int axis : {0, 1, 2}) point.position_mm[axis] = kMmPerUnit * source.number("position", kMostPlace);
    for (unsigned char& code : point.rgb) code = static_cast<unsigned char>(source.whole("colour", 255));
    source.word("error");
    read.points.push_back(point);
    if (!source.remaining().empty()) ++read.tracks;
  });
  return read;
}

ColmapPoints parse_colmap_points(std::span<const std::byte> binary, const std::string& where) {
  constexpr std::size_t kTrackBytes = 8;  // bytes of an element of a track: the image and the index of its point
  ColmapPoints read;
  ColmapBytes source(binary, where);
  const std::uint64_t count = source.whole("number of points", kAnyPoint);
  for (std::uint64_t i = 0; i < count; ++i) {
    source.enter(fmt::format("point {}", i + 1));
    source.next<std::uint64_t>();  // the point's number
    CloudPoint point;
    for (const int axis : {0, 1, 2}) point.position_mm[axis] = kMmPerUnit * source.number("position", kMostPlace);
    for (unsigned char& code : point.rgb) code = source.next<unsigned char>();
    source.next<double>();  // the error
    const std::uint64_t track = source.whole("track length", kAnyPoint);
    source.skip(track, kTrackBytes);
    read.points.push_back(point);
    if (track > 0) ++read.tracks;
  }
  return read;
}

}  // namespace lippmann
