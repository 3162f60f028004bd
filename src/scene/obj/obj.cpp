#include "scene/obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "scene/directions.hpp"
#include "scene/left_out.hpp"
#include "scene/lexer.hpp"
#include "scene/obj/materials.hpp"
#include "scene/polygon.hpp"
#include "scene/text_file.hpp"
#include "scene/wind_by_normals.hpp"

namespace lippmann {
namespace obj {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;
constexpr float kLargestCoordinate = 1e18f;  // squares and products of two such numbers are finite floats

struct Corner {
  int position = -1, uv = -1, normal = -1;
  bool operator==(const Corner&) const = default;
};

struct CornerHash {
  std::size_t operator()(const Corner& c) const {
    const auto wide = [](int i) { return static_cast<std::uint64_t>(i + 1); };
    return (wide(c.position) * 0x9e3779b97f4a7c15u) ^ (wide(c.uv) * 0xc2b2ae3d27d4eb4fu) ^
           (wide(c.normal) * 0x165667b19e3779f9u);
  }
};

/// The faces that have the same object, material and kinds of attributes.
struct Part {
  Mesh mesh;
  std::unordered_map<Corner, std::uint32_t, CornerHash> placed;
};

Vec3f linear(Vec3f srgb) {
  const auto decode = [](float v) { return static_cast<float>(linear_from_srgb(std::clamp(double{v}, 0.0, 1.0))); };
  return {decode(srgb.x), decode(srgb.y), decode(srgb.z)};
}

class Reader {
 public:
  Reader(Lexer& lexer, const SideFolders& folders, std::uint64_t texture_bytes, Scene& scene, const Context& context)
      : lexer_(lexer), scene_(scene), context_(context), materials_(folders, texture_bytes, scene, context) {}

  void read() {
    while (!lexer_.at_end()) {
      const std::string_view keyword = lexer_.word("a statement");
      if (!parse(keyword)) {
        if (keyword != "g") left_out_.add(keyword, lexer_.where());
        lexer_.rest_of_line();
      }
    }
    materials_.decode_textures();
    finish();
  }

 private:
  bool parse(std::string_view keyword) {
    if (keyword == "v")
      parse_position();
    else if (keyword == "vt")
      parse_uv();
    else if (keyword == "vn")
      normals_.push_back(vector("vn"));
    else if (keyword == "f")
      parse_face();
    else if (keyword == "usemtl")
      material_ = lexer_.rest_of_line(), part_ = nullptr;
    else if (keyword == "mtllib")
      materials_.read_library(lexer_.rest_of_line(), lexer_.where());
    else if (keyword == "s")
      parse_smoothing();
    else if (keyword == "o")
      object_ = lexer_.rest_of_line(), part_ = nullptr;
    else
      return false;
    return true;
  }

  void parse_smoothing() {
    const std::string_view group = lexer_.rest_of_line();
    is_smoothed_ = group != "off" && group != "0" && !group.empty();
  }

  void warn_about_smoothing() {
    if (!is_smoothed_ || warned_about_smoothing_) return;
    warned_about_smoothing_ = true;
    context_.warning(fmt::format("{}: faces of smoothing groups (s) without normals (vn) are faceted.", lexer_.where()));
  }

  void parse_position() {
    positions_.push_back(three("v", [&](int axis) { return lexer_.coordinate(axis, "v", kLargestCoordinate); }));
    std::array<float, 4> more{};
    std::size_t count = 0;
    while (count < more.size() && !lexer_.at_line_end()) more[count++] = lexer_.number("v", kLargestCoordinate);
    if (count < 3) return;
    colors_.resize(positions_.size(), Vec3f(1.0f));
    colors_.back() = linear({more[count - 3], more[count - 2], more[count - 1]});
  }

  template <class Read>
  Vec3f three(std::string_view keyword, const Read& read) {
    Vec3f result;
    for (int i = 0; i < 3; ++i) {
      if (lexer_.at_line_end()) throw lexer_.error(fmt::format("{} has {} numbers", keyword, i), "3 or more");
      result[i] = read(i);
    }
    return result;
  }

  Vec3f vector(std::string_view keyword) {
    return three(keyword, [&](int) { return lexer_.number(keyword, kLargestCoordinate); });
  }

  void parse_uv() {
    if (lexer_.at_line_end()) throw lexer_.error("vt has no number", "2 numbers");
    const float u = lexer_.number("vt", kLargestCoordinate);
    const float v = lexer_.at_line_end() ? 0.0f : lexer_.number("vt", kLargestCoordinate);
    uvs_.emplace_back(u, 1.0f - v);
    lexer_.rest_of_line();
  }

  /// Converts an index of the file, which counts from 1, or backwards from -1, to an index from 0. `size` is the number of
  /// elements so far.
  int index(std::string_view digits, std::size_t size, std::string_view word, const char* what) const {
    std::int64_t value = 0;
    const auto [rest, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const auto count = static_cast<std::int64_t>(size);
    if (failure != std::errc{} || rest != digits.data() + digits.size() || value == 0 || value > count || value < -count)
      throw lexer_.error(
          fmt::format("{} refers to a {} that does not exist", shown(word), what),
          count > 0 ? fmt::format("1 to {}, or -{} to -1", count, count) : fmt::format("a {} before the face", what));
    return static_cast<int>(value > 0 ? value - 1 : count + value);
  }

  Corner parse_corner(std::string_view word) const {
    const std::size_t first = std::min(word.find('/'), word.size());
    const std::size_t second = first == word.size() ? first : std::min(word.find('/', first + 1), word.size());
    Corner corner;
    corner.position = index(word.substr(0, first), positions_.size(), word, "vertex");
    if (first + 1 < second)
      corner.uv = index(word.substr(first + 1, second - first - 1), uvs_.size(), word, "texture coordinate");
    if (second + 1 < word.size()) corner.normal = index(word.substr(second + 1), normals_.size(), word, "normal");
    return corner;
  }

  void parse_face() {
    corners_.clear(), outline_.clear();
    while (!lexer_.at_line_end()) {
      corners_.push_back(parse_corner(lexer_.word("f")));
      outline_.push_back(positions_[static_cast<std::size_t>(corners_.back().position)]);
    }
    if (corners_.size() < 3) throw lexer_.error(fmt::format("a face has {} corners", corners_.size()), "3 or more");
    if (corners_.size() > kMostConcaveCorners && !turns_one_way(outline_))
      throw lexer_.error(fmt::format("a concave face has {} corners", corners_.size()),
                         fmt::format("at most {}", kMostConcaveCorners));
    const bool has_uv = std::all_of(corners_.begin(), corners_.end(), [](const Corner& c) { return c.uv >= 0; });
    const bool has_normal = std::all_of(corners_.begin(), corners_.end(), [&](const Corner& c) {
      return c.normal >= 0 && normals_[static_cast<std::size_t>(c.normal)] != Vec3f(0.0f);
    });
    if (!has_normal) warn_about_smoothing();
    Part& part = part_for(has_uv, has_normal);
    for (const Triangle& triangle : triangulate(outline_)) {
      std::array<std::uint32_t, 3> vertices{};
      for (std::size_t k = 0; k < 3; ++k) vertices[k] = vertex(part, corners_[triangle[k]], has_uv, has_normal);
      part.mesh.triangles.push_back(vertices);
    }
  }

  Part& part_for(bool has_uv, bool has_normal) {
    if (part_ && part_uv_ == has_uv && part_normal_ == has_normal) return *part_;
    part_uv_ = has_uv, part_normal_ = has_normal;
    const int material = materials_.find(material_, lexer_.where());
    part_ = &parts_[{object_, material, has_uv, has_normal}];
    return *part_;
  }

  std::uint32_t vertex(Part& part, Corner corner, bool has_uv, bool has_normal) {
    if (!has_uv) corner.uv = -1;
    if (!has_normal) corner.normal = -1;
    const auto [known, is_new] = part.placed.try_emplace(corner, static_cast<std::uint32_t>(part.mesh.positions.size()));
    if (!is_new) return known->second;
    const auto position = static_cast<std::size_t>(corner.position);
    part.mesh.positions.push_back(positions_[position]);
    if (has_uv) part.mesh.uvs.push_back(uvs_[static_cast<std::size_t>(corner.uv)]);
    if (has_normal) part.mesh.normals.push_back(direction_of(normals_[static_cast<std::size_t>(corner.normal)]));
    if (!colors_.empty()) {
      part.mesh.colors.resize(part.mesh.positions.size() - 1, Vec3f(1.0f));
      part.mesh.colors.push_back(position < colors_.size() ? colors_[position] : Vec3f(1.0f));
    }
    return known->second;
  }

  void finish() {
    left_out_.warn(context_, "statement", "statements");
    for (auto& [key, part] : parts_) {
      if (part.mesh.triangles.empty()) continue;
      wind_by_normals(part.mesh);
      if (!part.mesh.colors.empty()) part.mesh.colors.resize(part.mesh.positions.size(), Vec3f(1.0f));
      Instance instance;
      instance.name = std::get<0>(key);
      instance.shape = static_cast<int>(scene_.shapes.size());
      instance.material = std::get<1>(key);
      scene_.shapes.emplace_back(std::move(part.mesh));
      scene_.instances.push_back(std::move(instance));
    }
  }

  Lexer& lexer_;
  Scene& scene_;
  const Context& context_;
  Materials materials_;
  /// colors_ may be shorter than positions_; the remaining vertices are white.
  std::vector<Vec3f> positions_, normals_, colors_;
  std::vector<Vec2f> uvs_;
  std::vector<Corner> corners_;
  std::vector<Vec3f> outline_;
  std::string object_, material_;
  /// The key is: object name, material index, whether corners have texture coordinates, whether they have normals.
  std::map<std::tuple<std::string, int, bool, bool>, Part> parts_;
  Part* part_ = nullptr;
  bool part_uv_ = false, part_normal_ = false;
  bool is_smoothed_ = false, warned_about_smoothing_ = false;
  LeftOut left_out_;
};

/// Joins lines that end with a backslash to the next line. Comments are not joined because a backslash at their end may belong
/// to a folder name.
void join_lines(std::string& text) {
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1)) {
    const std::size_t end = at + 1 < text.size() && text[at + 1] == '\r' ? at + 2 : at + 1;
    if (end >= text.size() || text[end] != '\n') continue;
    const std::size_t line = text.rfind('\n', at) + 1;  // 0 if rfind() returns npos
    if (text[line] != '#') text[at] = text[end] = ' ';
  }
}

}  // namespace
}  // namespace obj

Scene load_obj(const std::filesystem::path& path, const Context& context, const std::filesystem::path& asset_root,
               std::uint64_t texture_bytes, const Vec3d& origin) {
  std::string text = utf8_text(read_text_file(path, path.string(), obj::kLargestFile, "at most 1 GiB of text"));
  obj::join_lines(text);
  Lexer lexer(path.string(), std::move(text));
  lexer.set_origin(origin);
  Scene scene;
  scene.origin = origin;
  scene.name = path.stem().string();
  obj::Reader(lexer, {path.parent_path(), asset_root}, texture_bytes, scene, context).read();
  return scene;
}

}  // namespace lippmann
