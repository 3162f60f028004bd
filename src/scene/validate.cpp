#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <type_traits>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/splats.hpp"

namespace lippmann {
namespace {

bool finite(float x) { return std::isfinite(x); }
template <glm::length_t L>
bool finite(const glm::vec<L, float>& v) {
  for (glm::length_t i = 0; i < L; ++i)
    if (!std::isfinite(v[i])) return false;
  return true;
}
bool finite(Quatf q) { return finite(Vec4f(q.w, q.x, q.y, q.z)); }
bool finite(const Affine3f& a) {
  return finite(a.linear[0]) && finite(a.linear[1]) && finite(a.linear[2]) && finite(a.translation);
}

/// Returns whether the length of v is within 1 % of 1, because files may store normals with 8 bits per component.
template <class V>
bool unit(const V& v) {
  return std::abs(glm::dot(v, v) - 1.0f) < 0.02f;
}

bool uniform(Vec3f scale) {
  const Vec3f s = glm::abs(scale);
  return std::max({s.x, s.y, s.z}) <= 1.001f * std::min({s.x, s.y, s.z});
}

bool similarity(const Mat3f& m) {
  const Vec3f square(glm::dot(m[0], m[0]), glm::dot(m[1], m[1]), glm::dot(m[2], m[2]));
  const float tolerance = 1e-3f * square.x;
  return uniform(glm::sqrt(square)) && std::abs(glm::dot(m[0], m[1])) <= tolerance &&
         std::abs(glm::dot(m[0], m[2])) <= tolerance && std::abs(glm::dot(m[1], m[2])) <= tolerance;
}

class Validator {
 public:
  Validator(const Scene& scene, const std::string& where) : scene_(scene), where_(where) {}

  void run() {
    check_nodes();
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i)
      std::visit([&](const auto& shape) { check_shape(shape, fmt::format("shape {}", i)); }, scene_.shapes[i]);
    for (std::size_t i = 0; i < scene_.textures.size(); ++i) check_texture(scene_.textures[i], i);
    for (std::size_t i = 0; i < scene_.materials.size(); ++i)
      std::visit([&](const auto& s) { check_surface(s, label("material", i, scene_.materials[i].name)); },
                 scene_.materials[i].surface);
    check_timeline();  // before the instances, whose checks use the animations
    for (std::size_t i = 0; i < scene_.skins.size(); ++i) check_skin(scene_.skins[i], i);
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) check_instance(scene_.instances[i], i);
    for (std::size_t i = 0; i < scene_.webs.size(); ++i) check_web(scene_.webs[i], i);
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) check_light(scene_.lights[i], i);
    for (std::size_t i = 0; i < scene_.cameras.size(); ++i) check_camera(scene_.cameras[i], i);
    check_rest();
  }

 private:
  void require(bool good, std::string_view element, std::string_view problem) const {
    if (!good) throw Error(where_, fmt::format("{}: {}", element, problem));
  }

  static std::string label(std::string_view kind, std::size_t index, const std::string& name) {
    return name.empty() ? fmt::format("{} {}", kind, index) : fmt::format("{} {} ({})", kind, index, name);
  }

  void require_index(int index, std::size_t count, int lowest, std::string_view element, std::string_view of) const {
    if (index < lowest || index >= static_cast<std::ptrdiff_t>(count))
      throw Error(where_, fmt::format("{}: {} {} is out of range", element, of, index),
                  count ? fmt::format("{} to {}", lowest, count - 1) : std::string("none, the scene has none"));
  }
  void require_node(int node, std::string_view element) const { require_index(node, scene_.nodes.size(), -1, element, "node"); }

  void check_shape(const Mesh& mesh, const std::string& element) const {
    const std::size_t vertices = mesh.positions.size();
    check_attribute(mesh.positions, vertices, element, "position");
    check_attribute(mesh.normals, vertices, element, "normal");
    check_attribute(mesh.uvs, vertices, element, "uv");
    check_attribute(mesh.uvs_1, vertices, element, "second uv");
    check_attribute(mesh.colors, vertices, element, "colour");
    check_attribute(mesh.alphas, vertices, element, "alpha");
    check_attribute(mesh.tangents, vertices, element, "tangent");
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
      if (!unit(mesh.normals[i])) require(false, element, fmt::format("the normal of vertex {} is not a unit vector", i));
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i)
      if (!unit(Vec3f(mesh.tangents[i])) || std::abs(mesh.tangents[i].w) != 1.0f)
        require(false, element, fmt::format("the tangent of vertex {} is not a unit vector with w = 1 or -1", i));
    for (const MorphTarget& target : mesh.targets) {
      check_attribute(target.positions, vertices, element, "morphed position");
      check_attribute(target.normals, vertices, element, "morphed normal");
      check_attribute(target.tangents, vertices, element, "morphed tangent");
    }
    check_skin_weights(mesh.skin, vertices, element);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (const std::uint32_t index : mesh.triangles[i])
        if (index >= vertices)
          require(false, element,
                  fmt::format("triangle {} refers to vertex {}, but the number of vertices is {}", i, index, vertices));
  }

  template <class T>
  void check_attribute(const std::vector<T>& values, std::size_t vertices, const std::string& element, const char* what) const {
    require(values.empty() || values.size() == vertices, element, fmt::format("needs one {} per vertex", what));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!finite(values[i])) require(false, element, fmt::format("the {} of vertex {} is not finite", what, i));
  }

  void check_skin_weights(const SkinWeights& skin, std::size_t vertices, const std::string& element) const {
    const std::size_t count = static_cast<std::size_t>(std::max(skin.per_vertex, 0)) * vertices;
    require(skin.per_vertex >= 0 && skin.joints.size() == count && skin.weights.size() == count, element,
            "the number of joints or weights does not match the vertices");
    for (const float weight : skin.weights) require(finite(weight) && weight >= 0.0f, element, "a weight is not a number >= 0");
    constexpr float kRounding = 0.01f;  // tolerance of the sum of weights, because files may store weights in 8 bits
    const auto per_vertex = static_cast<std::size_t>(skin.per_vertex);
    for (std::size_t v = 0; per_vertex > 0 && v < vertices; ++v) {
      const float sum = std::accumulate(skin.weights.begin() + static_cast<std::ptrdiff_t>(v * per_vertex),
                                        skin.weights.begin() + static_cast<std::ptrdiff_t>((v + 1) * per_vertex), 0.0f);
      if (std::abs(sum - 1.0f) > kRounding)
        require(false, element, fmt::format("the weights of vertex {} sum to {}, not 1", v, sum));
    }
  }

  void check_shape(const Splats& splats, const std::string& element) const {
    const std::size_t count = splats.centers.size();
    require(0 <= splats.degree && splats.degree <= 3, element, "the degree of its spherical harmonics is not 0 to 3");
    require(splats.rotations.size() == count && splats.deviations.size() == count && splats.opacities.size() == count &&
                splats.harmonics.size() == count * harmonics_of(splats.degree),
            element, "the arrays do not match the number of splats");
    for (std::size_t i = 0; i < count; ++i)
      if (!is_sound(splats, i)) require(false, element, fmt::format("splat {} is not finite or has zero size", i));
  }

  template <class T>
  void check_shape(const std::vector<T>& set, const std::string& element) const {
    for (std::size_t i = 0; i < set.size(); ++i)
      if (const char* problem = problem_of(set[i])) require(false, fmt::format("{}, element {}", element, i), problem);
  }

  static const char* problem_of(const Sphere& s) {
    if (!finite(s.center)) return "the sphere's center is not finite";
    return finite(s.radius) && s.radius > 0.0f ? nullptr : "the sphere's radius is not a positive number";
  }
  static const char* problem_of(const Cylinder& c) {
    if (!finite(c.base) || !finite(c.apex)) return "the cylinder's ends are not finite";
    if (c.base == c.apex) return "the cylinder has no length";
    return finite(c.radius) && c.radius > 0.0f ? nullptr : "the cylinder's radius is not a positive number";
  }
  static const char* problem_of(const Plane& p) {
    if (!finite(p.point)) return "the plane's point is not finite";
    return unit(p.normal) ? nullptr : "the plane's normal is not a unit vector";
  }
  static const char* problem_of(const Ring& r) {
    if (!finite(r.center)) return "the ring's center is not finite";
    if (!unit(r.normal)) return "the ring's normal is not a unit vector";
    const bool radii = finite(r.outer_radius) && 0.0f <= r.inner_radius && r.inner_radius < r.outer_radius;
    return radii ? nullptr : "the ring's radii are not 0 <= inner < outer";
  }
  static const char* problem_of(const Box& b) {
    if (!finite(b.lower) || !finite(b.upper)) return "the box's corners are not finite";
    return glm::all(glm::lessThanEqual(b.lower, b.upper)) ? nullptr : "the box's lower corner is above its upper one";
  }

  void check_texture(const Texture& texture, std::size_t index) const {
    const std::string element = label("texture", index, texture.name);
    require(texture.width > 0 && texture.height > 0, element, "has no pixels");
    const std::size_t bytes = 4 * static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
    require(texture.rgba.size() == bytes, element, "does not hold four bytes per pixel");
  }

  void require_texture(int texture, std::string_view element) const {
    require_index(texture, scene_.textures.size(), -1, element, "texture");
  }

  void check_surface(const PhongSurface& s, const std::string& element) const {
    require_texture(s.texture, element);
    require(finite(s.color) && finite(s.emission), element, "a colour is not finite");
    require(finite(Vec4f(s.ambient, s.diffuse, s.highlight, s.highlight_size)) && finite(Vec2f(s.mirror, s.opacity)), element,
            "a coefficient is not finite");
    require(finite(s.ior) && s.ior > 0.0f, element, "the index of refraction is not a positive number");
    if (!s.projection) return;
    const ImageProjection& p = *s.projection;
    require(finite(p.center) && finite(p.rotate) && finite(p.scale) && finite(p.u_axis) && finite(p.v_axis), element,
            "the image projection is not finite");
    require(p.kind == ProjectionKind::kPlane ||
                (unit(p.u_axis) && unit(p.v_axis) && std::abs(glm::dot(p.u_axis, p.v_axis)) < 1e-3f),
            element, "the axes of the image projection are not orthonormal");
  }

  void check_map(const TextureMap& map, const std::string& element) const {
    require_texture(map.texture, element);
    require(map.uv_set == 0 || map.uv_set == 1, element, "a map's uv set is not 0 or 1");
    require(finite(map.matrix[0]) && finite(map.matrix[1]) && finite(map.offset), element, "a map's transform is not finite");
  }

  void check_surface(const MetallicRoughness& s, const std::string& element) const {
    for (const TextureMap* map :
         {&s.base_color_map, &s.metallic_roughness_map, &s.normal_map, &s.occlusion_map, &s.emissive_map, &s.transmission_map,
          &s.specular_map, &s.specular_color_map, &s.clearcoat_map, &s.clearcoat_roughness_map, &s.clearcoat_normal_map})
      check_map(*map, element);
    require(finite(s.base_color) && finite(s.emissive) && finite(s.specular_color), element, "a colour is not finite");
    require(finite(Vec4f(s.metallic, s.roughness, s.transmission, s.alpha_cutoff)) &&
                finite(Vec4f(s.normal_scale, s.occlusion_strength, s.specular, s.clearcoat)) &&
                finite(Vec2f(s.clearcoat_roughness, s.clearcoat_normal_scale)),
            element, "a coefficient is not finite");
    require(finite(s.ior) && s.ior > 0.0f, element, "the index of refraction is not a positive number");
    if (s.extensions) check_extensions(*s.extensions, element);
  }

  void check_extensions(const SurfaceExtensions& s, const std::string& element) const {
    for (const TextureMap* map : {&s.sheen.color_map, &s.sheen.roughness_map, &s.anisotropy.map, &s.iridescence.map,
                                  &s.iridescence.thickness_map, &s.diffuse_transmission.map, &s.diffuse_transmission.color_map})
      check_map(*map, element);
    require(finite(s.sheen.color) && finite(s.diffuse_transmission.color), element, "a colour is not finite");
    require(finite(Vec4f(s.sheen.roughness, s.anisotropy.strength, s.anisotropy.rotation, s.dispersion)) &&
                finite(Vec2f(s.iridescence.share, s.diffuse_transmission.share)),
            element, "a coefficient is not finite");
    require(s.dispersion >= 0.0f, element, "the dispersion is negative");
    const Vec3f film(s.iridescence.ior, s.iridescence.least_thickness_nm, s.iridescence.most_thickness_nm);
    require(finite(film) && film.x >= 1.0f && film.y >= 0.0f && film.z >= 0.0f, element,
            "the film has an index of refraction below 1 or a thickness below 0");
    if (!s.volume) return;
    const Vec3f left = s.volume->attenuation_color;
    require(
        finite(left) && glm::all(glm::greaterThanEqual(left, Vec3f(0.0f))) && glm::all(glm::lessThanEqual(left, Vec3f(1.0f))),
        element, "the attenuation colour is not between 0 and 1");
    // An infinite distance is valid: the volume then absorbs nothing.
    require(s.volume->attenuation_distance > 0.0f, element, "the attenuation distance is not above 0");
  }

  void check_nodes() const {
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      const Node& node = scene_.nodes[i];
      const std::string element = label("node", i, node.name);
      require_index(node.parent, i, -1, element, "parent");
      if (node.matrix) require(finite(*node.matrix), element, "the matrix is not finite");
      const Transform& t = node.local;
      require(finite(t.translation) && finite(t.scale), element, "the transform is not finite");
      require(unit(Vec4f(t.rotation.w, t.rotation.x, t.rotation.y, t.rotation.z)), element,
              "the rotation is not a unit quaternion");
      for (const float weight : node.morph_weights) require(finite(weight), element, "a morph weight is not finite");
    }
  }

  void check_skin(const Skin& skin, std::size_t index) const {
    const std::string element = label("skin", index, skin.name);
    require(skin.joints.size() == skin.joint_from_mesh.size(), element, "needs one matrix per joint");
    for (const int joint : skin.joints) require_index(joint, scene_.nodes.size(), 0, element, "node");
    for (const Affine3f& matrix : skin.joint_from_mesh) require(finite(matrix), element, "a matrix is not finite");
  }

  void check_deformation(const Instance& instance, const std::string& element) const {
    require_index(instance.skin, scene_.skins.size(), -1, element, "skin");
    const Mesh* mesh = std::get_if<Mesh>(&scene_.shapes[static_cast<std::size_t>(instance.shape)]);
    if (instance.skin >= 0) {
      require(mesh && mesh->skin.per_vertex > 0, element, "has a skin, but its mesh has no weights");
      const std::size_t joints = scene_.skins[static_cast<std::size_t>(instance.skin)].joints.size();
      for (const std::uint32_t joint : mesh->skin.joints)
        if (joint >= joints)
          require(false, element, fmt::format("a vertex refers to joint {}, but the number of joints is {}", joint, joints));
    }
    if (!mesh || mesh->targets.empty()) return;
    const std::size_t weights =
        instance.node < 0 ? 0 : scene_.nodes[static_cast<std::size_t>(instance.node)].morph_weights.size();
    require(weights == mesh->targets.size(), element,
            fmt::format("has {} morph targets, but its node has {} weights", mesh->targets.size(), weights));
  }

  void check_instance(const Instance& instance, std::size_t index) const {
    const std::string element = label("instance", index, instance.name);
    require_index(instance.shape, scene_.shapes.size(), 0, element, "shape");
    require_index(instance.material, scene_.materials.size(), 0, element, "material");
    require_node(instance.node, element);
    check_deformation(instance, element);
    const Shape& shape = scene_.shapes[static_cast<std::size_t>(instance.shape)];
    if (std::holds_alternative<Mesh>(shape) || std::holds_alternative<Splats>(shape)) return;
    for (int node = instance.node; node >= 0; node = scene_.nodes[static_cast<std::size_t>(node)].parent)
      require(keeps_proportions(node), element, fmt::format("node {} scales an analytic shape non-uniformly", node));
  }

  bool keeps_proportions(int index) const {
    const Node& node = scene_.nodes[static_cast<std::size_t>(index)];
    if (node.matrix) return similarity(node.matrix->linear);
    if (!uniform(node.local.scale)) return false;
    for (const NodeAnimation& animation : scene_.timeline.animations)
      if (animation.node == index)
        for (const Vec3f& scale : animation.scale.values)
          if (!uniform(scale)) return false;
    return true;
  }

  void check_light(const Light& light, std::size_t index) const {
    const std::string element = label("light", index, light.name);
    require_node(light.node, element);
    require(finite(light.color), element, "the colour is not finite");
    require(light.range > 0.0f, element, "the range is not positive");
    const Vec3f a = light.attenuation;
    require(finite(a) && std::min({a.x, a.y, a.z}) >= 0.0f && a.x + a.y + a.z > 0.0f, element,
            "the attenuation is not three numbers >= 0, at least one of them > 0");
    require(0.0f <= light.inner_cone && light.inner_cone <= light.outer_cone && light.outer_cone <= kPi, element,
            "the cone angles are not 0 <= inner <= outer <= pi");
    require(finite(light.visible_radius) && light.visible_radius >= 0.0f, element, "the visible radius is not a number >= 0");
    check_light_size(light, element);
    require(light.web >= -1 && light.web < static_cast<int>(scene_.webs.size()), element, "the photometric web does not exist");
    require(light.web < 0 || (light.kind == LightKind::kPoint && light.inverse_square), element,
            "has a photometric web, which requires a point light with inverse-square falloff");
  }

  void check_web(const PhotometricWeb& web, std::size_t index) const {
    const std::string element = label("web", index, web.name);
    const auto increase = [](const std::vector<float>& angles, float lower, float upper) {
      return std::adjacent_find(angles.begin(), angles.end(), [](float a, float b) { return !(a < b); }) == angles.end() &&
             angles.front() >= lower && angles.back() <= upper;
    };
    require(web.polar.size() >= 2 && increase(web.polar, 0.0f, kPi), element,
            "the polar angles are not at least two, increasing within 0 to pi");
    require(!web.azimuth.empty() && increase(web.azimuth, -kPi, 2.0f * kPi), element,
            "the azimuths are not at least one, increasing within -pi to 2 pi");
    require(web.intensity.size() == web.polar.size() * web.azimuth.size() &&
                std::all_of(web.intensity.begin(), web.intensity.end(), [](float i) { return finite(i) && i >= 0.0f; }),
            element, "needs one intensity >= 0 for each pair of angles");
  }

  void check_light_size(const Light& light, const std::string& element) const {
    const bool is_sun = light.kind == LightKind::kDirectional;
    require(finite(light.radius) && light.radius >= 0.0f, element, "the radius is not a number >= 0");
    require(light.radius == 0.0f || (!is_sun && light.inverse_square && light.attenuation == Vec3f(1.0f, 0.0f, 0.0f)), element,
            "has a radius, which requires a point or spot light with pure inverse-square falloff");
    require(0.0f <= light.angular_diameter && light.angular_diameter <= kPi, element,
            "the angular diameter is not between 0 and pi");
    require(light.angular_diameter == 0.0f || is_sun, element,
            "has an angular diameter, which only directional lights may have");
  }

  void check_camera(const Camera& camera, std::size_t index) const {
    const std::string element = label("camera", index, camera.name);
    require_node(camera.node, element);
    require(camera.vertical_fov > 0.0f && camera.vertical_fov < kPi, element,
            "the field of view is not between 0 and 180 degrees");
    require(finite(camera.aspect) && camera.aspect >= 0.0f, element, "the aspect ratio is not a number >= 0");
    require(finite(camera.focus_distance) && camera.focus_distance >= 0.0f, element, "the focus distance is not a number >= 0");
    require(finite(camera.pixel_offset), element, "the pixel offset is not finite");
    require(finite(camera.orthographic_height) && camera.orthographic_height >= 0.0f, element,
            "the orthographic height is not a number >= 0");
    require(finite(camera.near_distance) && camera.near_distance >= 0.0f, element, "the near distance is not a number >= 0");
    require(finite(camera.shift), element, "the shift is not finite");
  }

  void check_rest() const {
    if (scene_.display) {
      require_node(scene_.display->node, "display");
      require(finite(scene_.display->plane_height) && scene_.display->plane_height > 0.0f, "display",
              "the height is not positive");
      require(scene_.display->viewing_distance > 0.0f, "display", "the viewing distance is not positive");
    }
    const Background& b = scene_.background;
    require(finite(b.horizon) && finite(b.zenith), "background", "a colour is not finite");
    require(unit(b.up), "background", "up is not a unit vector");
    require(finite(b.horizon_at) && finite(b.zenith_at) && b.horizon_at != b.zenith_at, "background",
            "the heights of horizon and zenith are equal or not finite");
    if (b.map) check_environment(*b.map);
    require_index(scene_.animation, scene_.animation_names.size(), -1, "animation", "animation");
    require(std::isfinite(scene_.origin.x + scene_.origin.y + scene_.origin.z), "origin", "is not finite");
    require(scene_.max_depth >= 1, "max_depth", "is below 1");
    require(scene_.resolution.x >= 0 && scene_.resolution.y >= 0, "resolution", "is negative");
  }

  void check_environment(const EnvironmentMap& map) const {
    const Image& panorama = map.radiance;
    const std::size_t samples = 3 * static_cast<std::size_t>(panorama.width) * static_cast<std::size_t>(panorama.height);
    require(panorama.width > 0 && panorama.height > 0 && panorama.channels == 3 && panorama.data.size() == samples,
            "environment", "is not a picture of three channels");
    require(panorama.width <= EnvironmentMap::kMostWidth && panorama.height <= EnvironmentMap::kMostHeight, "environment",
            fmt::format("has more than {} x {} pixels", EnvironmentMap::kMostWidth, EnvironmentMap::kMostHeight));
    require(std::all_of(panorama.data.begin(), panorama.data.end(), [](float v) { return v >= 0.0f && std::isfinite(v); }),
            "environment", "a sample is negative or not finite");
    require(finite(map.strength) && map.strength >= 0.0f && finite(map.rotation), "environment",
            "the strength is not a number >= 0, or the rotation is not finite");
  }

  void check_timeline() const {
    const Timeline& timeline = scene_.timeline;
    require(std::isfinite(timeline.frames_per_second) && timeline.frames_per_second > 0.0, "timeline",
            "frames per second is not a positive number");
    require(timeline.frame_count >= 1, "timeline", "has no frames");
    std::set<int> animated;
    for (std::size_t i = 0; i < timeline.animations.size(); ++i) {
      const NodeAnimation& animation = timeline.animations[i];
      const std::string element = fmt::format("animation {}", i);
      require_index(animation.node, scene_.nodes.size(), 0, element, "node");
      require(animated.insert(animation.node).second, element, fmt::format("node {} is animated twice", animation.node));
      const Node& node = scene_.nodes[static_cast<std::size_t>(animation.node)];
      const bool moves =
          !animation.translation.times.empty() || !animation.rotation.times.empty() || !animation.scale.times.empty();
      require(!node.matrix || !moves, element, "animates a node with a matrix");
      check_channel(animation.morph_weights, element + ", morph weights", node.morph_weights.size());
      check_channel(animation.translation, element + ", translation");
      check_channel(animation.rotation, element + ", rotation");
      check_channel(animation.scale, element + ", scale");
    }
  }

  template <class T>
  void check_channel(const Channel<T>& channel, const std::string& element, std::size_t count = 1) const {
    const std::size_t per_key = count * (channel.interpolation == Interpolation::kCubicSpline ? 3 : 1);
    require(channel.values.size() == per_key * channel.times.size(), element, fmt::format("needs {} values per key", per_key));
    for (std::size_t i = 0; i < channel.times.size(); ++i) {
      require(std::isfinite(channel.times[i]), element, "a time is not finite");
      require(i == 0 || channel.times[i - 1] < channel.times[i], element, "times do not increase");
    }
    for (const T& value : channel.values) require(finite(value), element, "a value is not finite");
  }

  const Scene& scene_;
  const std::string& where_;
};

}  // namespace

void validate(const Scene& scene, const std::string& where) { Validator(scene, where).run(); }

}  // namespace lippmann
