#include "formats/cvkit_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr double kMostCvkit = 1e9;

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

class CvkitProperties {
 public:
  CvkitProperties(std::string_view text, const std::string& where) : where_(where) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view line = without_blanks(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      const std::size_t equals = line.find('=');
      if (line.empty() || line[0] == '#' || equals == std::string_view::npos) continue;
      values_[std::string(without_blanks(line.substr(0, equals)))] = without_blanks(line.substr(equals + 1));
    }
  }

  bool has(const std::string& key) const { return values_.contains(key); }

  /// Numbers of a matrix or vector in brackets, row by row, or a single number.
  std::vector<double> numbers(const std::string& key, std::size_t count) const {
    const auto found = values_.find(key);
    if (found == values_.end()) throw Error(where_, "has no " + key);
    std::string_view rest = found->second;
    std::vector<double> numbers;
    constexpr std::string_view kBetween = "[]; \t,";
    const std::string accepted =
        fmt::format("{} of at most {}", count == 1 ? "a number" : fmt::format("{} numbers", count), kMostCvkit);
    while (true) {
      rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
      if (rest.empty()) break;
      double number = 0.0;
      const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
      if (problem != std::errc() || !(std::abs(number) <= kMostCvkit)) reject(key, accepted);
      numbers.push_back(number);
      rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    }
    if (numbers.size() != count) reject(key, accepted);
    return numbers;
  }

  double number_or(const std::string& key, double otherwise) const { return has(key) ? numbers(key, 1)[0] : otherwise; }

  [[noreturn]] void reject(const std::string& key, const std::string& accepted) const {
    throw Error(where_, fmt::format("its {} is {}", key, shown(values_.at(key))), accepted);
  }

 private:
  const std::string& where_;
  std::map<std::string, std::string> values_;
};

void require_no_distortion(const CvkitProperties& properties, const std::string& where) {
  for (const char* key : {"k1", "k2", "k3", "p1", "p2", "e1", "e2", "e3", "e4"})
    if (properties.number_or(std::string("camera.") + key, 0.0) != 0.0)
      throw Error(where, fmt::format("has a lens distortion, camera.{}", key), "rectified pictures");
}

Vec2i resolution_of(const CvkitProperties& properties, const std::string& where) {
  Vec2i size(0);
  for (const int axis : {0, 1}) {
    const double side = properties.number_or(axis == 0 ? "camera.width" : "camera.height", 0.0);
    if (!(side >= 0.0 && side <= 65536.0 && side == std::floor(side)))
      throw Error(where, fmt::format("its size is {}", side), "0 to 65536 pixels");
    size[axis] = static_cast<int>(side);
  }
  return size;
}

glm::dmat3 rotation_of(const CvkitProperties& properties, const std::string& where) {
  double rows[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  if (properties.has("camera.R")) std::ranges::copy(properties.numbers("camera.R", 9), rows);
  return checked_rotation(rows, where + ": camera.R");
}

/// Converts a rotation between the axes (right, down, forward) and (right, up, backwards), in the camera and in the world.
glm::dmat3 flipped(const glm::dmat3& rotation) {
  const glm::dmat3 flip(Vec3d(1.0, 0.0, 0.0), Vec3d(0.0, -1.0, 0.0), Vec3d(0.0, 0.0, -1.0));
  return flip * rotation * flip;
}

}  // namespace

CvkitCamera parse_cvkit_camera(const std::string& text, const std::string& where) {
  const CvkitProperties properties(text, where);
  const std::vector<double> a = properties.numbers("camera.A", 9);
  constexpr double kLeastFocal = 1e-6;
  if (a[1] != 0.0 || a[3] != 0.0 || a[6] != 0.0 || a[7] != 0.0 || a[8] != 1.0 || !(a[0] >= kLeastFocal && a[4] >= kLeastFocal))
    throw Error(where, "its camera.A has another form", "[fx 0 cx; 0 fy cy; 0 0 1], fx and fy above 0");
  require_no_distortion(properties, where);
  const std::vector<double> t =
      properties.has("camera.T") ? properties.numbers("camera.T", 3) : std::vector<double>{0.0, 0.0, 0.0};
  CvkitCamera read;
  read.camera = miv_camera({resolution_of(properties, where),
                            {a[0], a[4]},
                            {a[2], a[5]},
                            flipped(rotation_of(properties, where)),
                            1e3 * Vec3d(t[0], -t[1], -t[2])});
  read.rho = properties.number_or("rho", properties.number_or("camera.rho", 0.0));
  if (!(read.rho >= 0.0)) throw Error(where, fmt::format("its rho is {}", read.rho), "0 or more");
  if (properties.has("t") && !(properties.numbers("t", 1)[0] > 0.0))
    properties.reject("t", "a distance between cameras above 0");
  return read;
}

std::string cvkit_camera_text(const CvkitCamera& c) {
  const MivCamera& camera = c.camera;
  const double* position = camera.position_m;
  std::string text = fmt::format("camera.A=[{} 0 {}; 0 {} {}; 0 0 1]\n", camera.focal_px.x, camera.principal_point_px.x,
                                 camera.focal_px.y, camera.principal_point_px.y);
  const glm::dmat3 rows = glm::transpose(flipped(posed_camera(camera, camera.resolution).rotation)) + 0.0;
  text += fmt::format("camera.R=[{} {} {}; {} {} {}; {} {} {}]\n", rows[0].x, rows[0].y, rows[0].z, rows[1].x, rows[1].y,
                      rows[1].z, rows[2].x, rows[2].y, rows[2].z);
  text += fmt::format("camera.T=[{} {} {}]\n", 0.0 - position[1], 0.0 - position[2], position[0]);
  text += fmt::format("camera.width={}\ncamera.height={}\n", camera.resolution.x, camera.resolution.y);
  if (c.rho > 0.0) text += fmt::format("rho={}\nt={}\n", c.rho, c.rho / camera.focal_px.x);
  return text;
}

}  // namespace lippmann
