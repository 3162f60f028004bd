#include "scene/ply.hpp"

#include <fmt/format.h>

#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"
#include "scene/ply/body.hpp"
#include "scene/ply/header.hpp"
#include "scene/ply/mesh.hpp"
#include "scene/ply/points.hpp"
#include "scene/ply/splats.hpp"
#include "scene/text_file.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kLargestPly = std::size_t{1} << 30;

}  // namespace

Scene parse_ply(const std::string& name, const std::string& contents, const Context& context, const PlyOptions& options) {
  const ply::Header header = ply::parse_header(name, contents);
  header.foreign_lines.warn(context, "line", "lines");
  ply::Body body(name, std::string_view(contents).substr(header.size), header.format);
  const bool has_splats = ply::has_splats(header);
  if (!has_splats && ply::has_points(header))
    return ply::read_points(name, header, body, options.point_size, options.origin, context);
  if (options.point_size > 0.0)
    throw usage_error("points", fmt::format("{} is not a point cloud", name), "a PLY file without faces");
  if (has_splats) return ply::read_splats(name, header, body, options.origin, context);
  Scene scene;
  scene.origin = options.origin;
  SideTextures textures(options.folders, options.texture_bytes, scene, context);
  ply::read_mesh(name, header, body, textures, context, scene);
  textures.decode();
  return scene;
}

bool is_ply_splat_file(const std::filesystem::path& path) {
  constexpr std::size_t kMostHeader = 1 << 16;
  try {
    const ply::Header header = ply::parse_header(path.string(), read_file_begin(path, kMostHeader));
    return ply::has_splats(header) || ply::has_point_colors(header);
  } catch (const Error&) {
    return false;
  }
}

Scene load_ply(const std::filesystem::path& path, const Context& context, PlyOptions options) {
  const std::string name = path.string();
  const std::string contents = utf8_text(read_text_file(path, name, kLargestPly, "at most 1 GiB"));
  options.folders.folder = path.parent_path();
  Scene scene = parse_ply(name, contents, context, options);
  scene.name = path.stem().string();
  return scene;
}

}  // namespace lippmann
