#include "scene/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <initializer_list>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "scene/directions.hpp"
#include "scene/ply/header.hpp"
#include "scene/ply/splats.hpp"
#include "scene/polygon.hpp"
#include "scene/text_file.hpp"
#include "scene/wind_by_normals.hpp"

namespace lippmann {
namespace ply {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;
constexpr double kLargestNumber = 1e18;  // squares and products of two of them stay finite in floats

constexpr const char* kArePacked = "its splats are packed, as PlayCanvas and SuperSplat write .compressed.ply";
constexpr const char* kUnpacked =
    "a .ply of plain splats, which splat-transform IN OUT.ply makes of it (npm's @playcanvas/splat-transform)";

/// Takes the body's values one after the other.
class Body {
 public:
  Body(const std::string& name, std::string_view bytes, Format format) : name_(name), bytes_(bytes), format_(format) {}

  /// What errors call the values to come.
  void set_place(const std::string& element, std::int64_t row) { element_ = &element, row_ = row; }

  double value(Type type) {
    if (format_ == Format::kText) return text_value();
    const auto size = static_cast<std::size_t>(bytes_of(type));
    if (bytes_.size() < size) throw error("the file ends here");
    unsigned char raw[8];
    std::memcpy(raw, bytes_.data(), size);
    bytes_.remove_prefix(size);
    if ((format_ == Format::kLittleEndian) != (std::endian::native == std::endian::little)) std::reverse(raw, raw + size);
    return decoded(raw, type);
  }

  /// A finite value of a size that can be computed with.
  double bounded(Type type) {
    const double result = value(type);
    if (!(std::abs(result) <= kLargestNumber)) throw error(fmt::format("has the value {}", result), "at most 1e18");
    return result;
  }

  /// A whole number from 0 to `highest`.
  std::uint32_t index(Type type, double highest, std::string_view what) { return checked_index(value(type), highest, what); }

  std::uint32_t checked_index(double result, double highest, std::string_view what) const {
    if (!(0.0 <= result && result <= highest && result == std::floor(result)))
      throw error(fmt::format("{} is {}", what, result), fmt::format("0 to {}", highest));
    return static_cast<std::uint32_t>(result);
  }

  Error error(std::string problem, std::string accepted = {}) const {
    return {fmt::format("{}: {} {}", name_, printable(*element_), row_), std::move(problem), std::move(accepted)};
  }

 private:
  double text_value() {
    const std::size_t begin = std::min(bytes_.find_first_not_of(" \t\r\n"), bytes_.size());
    const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", begin), bytes_.size());
    const std::string_view word = bytes_.substr(begin, end - begin);
    bytes_.remove_prefix(end);
    if (word.empty()) throw error("the file ends here");
    double result = 0.0;
    const auto [rest, failure] = std::from_chars(word.data(), word.data() + word.size(), result);
    const bool tiny = failure == std::errc::result_out_of_range && word.find("e-") != word.npos;
    if (rest != word.data() + word.size() || (failure != std::errc{} && !tiny))
      throw error(fmt::format("{} is not a number", shown(word)));
    return tiny ? 0.0 : result;
  }

  template <class T>
  static double as(const unsigned char* raw) {
    T result;
    std::memcpy(&result, raw, sizeof result);
    return static_cast<double>(result);
  }

  static double decoded(const unsigned char* raw, Type type) {
    switch (type) {
      case Type::kInt8:
        return as<std::int8_t>(raw);
      case Type::kUint8:
        return as<std::uint8_t>(raw);
      case Type::kInt16:
        return as<std::int16_t>(raw);
      case Type::kUint16:
        return as<std::uint16_t>(raw);
      case Type::kInt32:
        return as<std::int32_t>(raw);
      case Type::kUint32:
        return as<std::uint32_t>(raw);
      case Type::kFloat:
        return as<float>(raw);
      case Type::kDouble:
        return as<double>(raw);
    }
    return 0.0;
  }

  const std::string& name_;
  std::string_view bytes_;
  Format format_;
  const std::string* element_ = nullptr;
  std::int64_t row_ = 0;
};

/// The first property of one of these names; -1: none.
int find(const Element& element, std::initializer_list<std::string_view> names) {
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (std::find(names.begin(), names.end(), element.properties[i].name) != names.end()) return static_cast<int>(i);
  return -1;
}

/// What integers count as 1.
double full_scale(Type type) {
  constexpr double kFull[] = {127.0, 255.0, 32767.0, 65535.0, 2147483647.0, 4294967295.0, 1.0, 1.0};
  return kFull[static_cast<int>(type)];
}

class Reader {
 public:
  Reader(const std::string& name, const Header& header, Body& body, const Context& context, const Vec3d& origin)
      : name_(name), header_(header), body_(body), context_(context), origin_(origin) {}

  Mesh read() {
    for (const Element& element : header_.elements) {
      if (element.properties.empty()) continue;  // rows of nothing
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "tristrips")
        read_strips(element);
      else
        skip(element);
    }
    if (mesh_.triangles.empty()) throw Error(name_, "has no faces", "a mesh; points alone are not shown");
    const auto is_zero = [](Vec3f n) { return n == Vec3f(0.0f); };
    if (std::any_of(mesh_.normals.begin(), mesh_.normals.end(), is_zero)) mesh_.normals.clear();
    for (Vec3f& normal : mesh_.normals) normal = direction_of(normal);
    wind_by_normals(mesh_);
    return std::move(mesh_);
  }

 private:
  void read_list(const Property& list, std::vector<std::uint32_t>* indices) {
    const double most = indices ? static_cast<double>(mesh_.positions.size()) : 4294967295.0;
    const std::uint32_t count = body_.index(*list.count_type, most, "the length of a list");
    for (std::uint32_t i = 0; i < count; ++i) {
      if (indices)
        indices->push_back(body_.index(list.type, static_cast<double>(mesh_.positions.size()) - 1.0, "a vertex"));
      else
        body_.value(list.type);
    }
  }

  /// Scalars of a row to row_, lists are passed over.
  void read_row(const Element& element, std::int64_t row) {
    body_.set_place(element.name, row);
    row_.resize(element.properties.size());
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      if (property.count_type)
        read_list(property, nullptr), row_[i] = 0.0;
      else
        row_[i] = body_.bounded(property.type);
    }
  }

  double exact(int property) const { return row_[static_cast<std::size_t>(property)]; }
  float at(int property) const { return static_cast<float>(exact(property)); }

  /// A colour's share, encoded as the file has it.
  double share(const Element& element, int property) const {
    const auto i = static_cast<std::size_t>(property);
    return std::clamp(row_[i] / full_scale(element.properties[i].type), 0.0, 1.0);
  }

  void read_vertices(const Element& element) {
    const int x = find(element, {"x"}), y = find(element, {"y"}), z = find(element, {"z"});
    if (find(element, {"packed_position"}) >= 0) throw Error(name_, kArePacked, kUnpacked);
    if (x < 0 || y < 0 || z < 0) throw Error(name_, "its vertices have no position", "properties x, y and z");
    if (!mesh_.positions.empty()) throw Error(name_, "has two lists of vertices", "one element \"vertex\"");
    const int nx = find(element, {"nx"}), ny = find(element, {"ny"}), nz = find(element, {"nz"});
    const int u = find(element, {"u", "s", "texture_u"}), v = find(element, {"v", "t", "texture_v"});
    const int red = find(element, {"red", "r", "diffuse_red"}), green = find(element, {"green", "g", "diffuse_green"});
    const int blue = find(element, {"blue", "b", "diffuse_blue"}), alpha = find(element, {"alpha", "a"});
    const auto linear = [&](int p) { return static_cast<float>(linear_from_srgb(share(element, p))); };
    for (std::int64_t row = 0; row < element.count; ++row) {
      read_row(element, row);
      mesh_.positions.push_back(Vec3f(Vec3d(exact(x), exact(y), exact(z)) - origin_));
      if (std::min({nx, ny, nz}) >= 0) mesh_.normals.emplace_back(at(nx), at(ny), at(nz));
      if (std::min(u, v) >= 0) mesh_.uvs.emplace_back(at(u), 1.0f - at(v));
      if (std::min({red, green, blue}) >= 0) mesh_.colors.emplace_back(linear(red), linear(green), linear(blue));
      if (alpha >= 0) mesh_.alphas.push_back(static_cast<float>(share(element, alpha)));
    }
  }

  /// A value that ends one strip and begins the next: -1, in whatever type.
  static bool ends_strip(double value) { return value == -1.0 || value == 4294967295.0; }

  void pass_over(const Property& property) {
    if (property.count_type)
      read_list(property, nullptr);
    else
      body_.value(property.type);
  }

  /// Calls read_vertex_list(property) where the list of vertices of a row begins, for each row; passes over all else.
  template <class ReadVertexList>
  void read_corners(const Element& element, std::string_view plural, const ReadVertexList& read_vertex_list) {
    const int list = find(element, {"vertex_indices", "vertex_index"});
    if (list < 0 || !element.properties[static_cast<std::size_t>(list)].count_type)
      throw Error(name_, fmt::format("its {} have no vertices", plural), "a list vertex_indices");
    for (std::int64_t row = 0; row < element.count; ++row) {
      body_.set_place(element.name, row);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const Property& property = element.properties[i];
        if (static_cast<int>(i) == list)
          read_vertex_list(property);
        else
          pass_over(property);
      }
    }
  }

  /// Strips of triangles, as Stanford's scans have them: a list of vertices in which -1 ends a strip.
  void read_strips(const Element& element) {
    read_corners(element, "strips", [this](const Property& list) { read_strip_list(list); });
  }

  void read_strip_list(const Property& list) {
    const std::uint32_t count = body_.index(*list.count_type, 4294967295.0, "the length of a list");
    corners_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      const double value = body_.value(list.type);
      if (ends_strip(value))
        corners_.clear();
      else
        extend_strip(body_.checked_index(value, static_cast<double>(mesh_.positions.size()) - 1.0, "a vertex"));
    }
  }

  /// Every second triangle of a strip winds the other way. Two equal corners are how strips are joined.
  void extend_strip(std::uint32_t corner) {
    corners_.push_back(corner);
    const std::size_t n = corners_.size();
    if (n < 3) return;
    std::uint32_t a = corners_[n - 3], b = corners_[n - 2];
    if (n % 2 == 0) std::swap(a, b);
    if (a != b && b != corner && a != corner) mesh_.triangles.push_back({a, b, corner});
  }

  void read_faces(const Element& element) {
    read_corners(element, "faces", [this](const Property& list) {
      corners_.clear(), outline_.clear();
      read_list(list, &corners_);
      add_face();
    });
  }

  void add_face() {
    for (const std::uint32_t corner : corners_) outline_.push_back(mesh_.positions[corner]);
    if (corners_.size() > kMostConcaveCorners && !turns_one_way(outline_))
      throw body_.error(fmt::format("is not convex and has {} corners", corners_.size()),
                        fmt::format("at most {}", kMostConcaveCorners));
    for (const Triangle& t : triangulate(outline_)) mesh_.triangles.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
  }

  void skip(const Element& element) {
    context_.warning(fmt::format("{}: the elements {} are left out.", name_, shown(element.name)));
    for (std::int64_t row = 0; row < element.count; ++row) {
      body_.set_place(element.name, row);
      for (const Property& property : element.properties) pass_over(property);
    }
  }

  const std::string& name_;
  const Header& header_;
  Body& body_;
  const Context& context_;
  Vec3d origin_;
  Mesh mesh_;
  std::vector<double> row_;
  std::vector<std::uint32_t> corners_;  ///< the corners of the face that is being read
  std::vector<Vec3f> outline_;
};

MetallicRoughness surface_of(const Mesh& mesh) {
  MetallicRoughness surface;
  surface.base_color = Vec4f(Vec3f(mesh.colors.empty() ? 0.8f : 1.0f), 1.0f);
  surface.metallic = 0.0f;
  surface.double_sided = true;
  surface.blend = std::any_of(mesh.alphas.begin(), mesh.alphas.end(), [](float alpha) { return alpha < 1.0f; });
  return surface;
}

}  // namespace
}  // namespace ply

Scene parse_ply(const std::string& name, const std::string& contents, const Context& context, const Vec3d& origin) {
  const ply::Header header = ply::parse_header(name, contents);
  if (ply::has_splats(header)) return ply::read_splats(name, header, std::string_view(contents).substr(header.size), context);
  ply::Body body(name, std::string_view(contents).substr(header.size), header.format);
  Mesh mesh = ply::Reader(name, header, body, context, origin).read();
  Scene scene;
  scene.origin = origin;
  scene.materials.push_back({"surface", ply::surface_of(mesh)});
  scene.shapes.emplace_back(std::move(mesh));
  Instance instance;
  instance.name = "mesh";
  instance.shape = instance.material = 0;
  scene.instances.push_back(std::move(instance));
  return scene;
}

bool is_ply_of_splats(const std::filesystem::path& path) {
  constexpr std::size_t kMostHeader = 1 << 16;
  std::string start(kMostHeader, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
  try {
    return ply::has_splats(ply::parse_header(path.string(), start));
  } catch (const Error&) {
    return false;
  }
}

Scene load_ply(const std::filesystem::path& path, const Context& context, const Vec3d& origin) {
  const std::string name = path.string();
  Scene scene = parse_ply(name, utf8_text(read_text_file(path, name, ply::kLargestFile, "at most 1 GiB")), context, origin);
  scene.name = path.stem().string();
  return scene;
}

}  // namespace lippmann
