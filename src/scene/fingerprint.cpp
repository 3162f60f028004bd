#include "scene/fingerprint.hpp"

#include "core/fingerprint.hpp"

// Every structured binding lists all members of its struct. A new member causes a compile error until it is hashed.

namespace lippmann {
namespace {

/// Types that consist only of 1-byte, 4-byte or 8-byte numbers, so that they contain no padding bytes.
template <class T>
concept Packed = std::is_trivially_copyable_v<T> &&(alignof(T) == 4 || alignof(T) == 8 || sizeof(T) == 1) &&
                 sizeof(T) % alignof(T) == 0;

class SceneFingerprint {
 public:
  std::uint64_t value() const { return print_.value(); }

  void add(const Scene& scene) {
    const auto& [name, nodes, shapes, textures, materials, instances, skins, lights, webs, cameras, display, background,
                 timeline, animation_names, animation, variant_names, origin, encoding, max_depth, resolution, kind] = scene;
    static_cast<void>(kind);  // kind only selects default options
    add_each(nodes);
    add_each(shapes);
    add_each(textures);
    add_each(materials);
    add_each(instances);
    add_each(skins);
    add_each(lights);
    if (!webs.empty()) add_each(webs);  // skipped if empty, so that existing scenes keep their fingerprint
    add_each(cameras);
    add_optional(display);
    add(background);
    add(timeline);
    add_all(encoding, max_depth, resolution);
    if (origin != Vec3d(0.0)) add(origin);  // skipped if zero, so that existing scenes keep their fingerprint
  }

 private:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add(T value) { print_.add(value); }
  template <int N, class T>
  void add(const glm::vec<N, T>& v) {
    for (int i = 0; i < N; ++i) print_.add(v[i]);
  }
  void add(const glm::mat2& m) { add_all(m[0], m[1]); }
  void add(const Quatf& q) { add_all(q.w, q.x, q.y, q.z); }
  void add(const Affine3f& a) { add_all(a.linear[0], a.linear[1], a.linear[2], a.translation); }

  template <class... T>
  void add_all(const T&... values) {
    (add(values), ...);
  }
  template <class T>
  void add_each(const std::vector<T>& values) {
    print_.add(values.size());
    for (const T& value : values) add(value);
  }
  template <Packed T>
  void add_packed(const std::vector<T>& values) {
    print_.add_bytes(values.data(), values.size() * sizeof(T));
  }
  template <class T>
  void add_optional(const std::optional<T>& value) {
    print_.add(value.has_value());
    if (value) add(*value);
  }

  void add(const Shape& shape) {
    print_.add(shape.index());
    std::visit([&](const auto& s) { add_shape(s); }, shape);
  }
  void add_shape(const Mesh& mesh) {
    const auto& [positions, normals, uvs, triangles, colors, alphas, uvs_1, tangents, targets, skin] = mesh;
    add_packed(positions);
    add_packed(normals);
    add_packed(uvs);
    add_packed(triangles);
    add_packed(colors);
    add_packed(alphas);
    add_packed(uvs_1);
    add_packed(tangents);
    add_each(targets);
    add(skin);
  }
  void add(const MorphTarget& target) {
    const auto& [positions, normals, tangents] = target;
    add_packed(positions);
    add_packed(normals);
    add_packed(tangents);
  }
  void add(const SkinWeights& skin) {
    const auto& [per_vertex, joints, weights] = skin;
    add(per_vertex);
    add_packed(joints);
    add_packed(weights);
  }
  void add_shape(const Splats& splats) {
    const auto& [centers, rotations, deviations, opacities, degree, harmonics, is_linear] = splats;
    add_packed(centers);
    add_packed(rotations);
    add_packed(deviations);
    add_packed(opacities);
    add_packed(harmonics);
    add_all(degree, is_linear);
  }
  template <class Primitive>
  void add_shape(const std::vector<Primitive>& primitives) {
    add_packed(primitives);
  }

  void add(const Texture& texture) {
    const auto& [name, width, height, rgba, srgb, wrap_u, wrap_v] = texture;
    add_all(width, height, srgb, wrap_u, wrap_v);
    add_packed(rgba);
  }

  void add(const ImageProjection& projection) {
    const auto& [kind, center, rotate, scale, u_axis, v_axis] = projection;
    add_all(kind, center, rotate, scale, u_axis, v_axis);
  }
  void add(const PhongSurface& surface) {
    const auto& [color, texture, projection, ambient, diffuse, highlight_kind, highlight, highlight_size, mirror, opacity, ior,
                 emission] = surface;
    add_all(color, texture, ambient, diffuse, highlight_kind, highlight, highlight_size, mirror, opacity, ior, emission);
    add_optional(projection);
  }
  void add(const TextureMap& map) {
    const auto& [texture, uv_set, matrix, offset] = map;
    add_all(texture, uv_set, matrix, offset);
  }
  void add(const MetallicRoughness& surface) {
    const auto& [base_color, base_color_map, metallic, roughness, metallic_roughness_map, normal_map, normal_scale,
                 occlusion_map, occlusion_strength, emissive, emissive_map, ior, transmission, transmission_map, specular,
                 specular_map, specular_color, specular_color_map, clearcoat, clearcoat_roughness, clearcoat_map,
                 clearcoat_roughness_map, clearcoat_normal_map, clearcoat_normal_scale, alpha_cutoff, blend, double_sided,
                 unlit, extensions] = surface;
    add_all(base_color, base_color_map, metallic, roughness, metallic_roughness_map, normal_map, normal_scale, occlusion_map,
            occlusion_strength, emissive, emissive_map, ior, transmission, transmission_map, specular, specular_map,
            specular_color, specular_color_map, clearcoat, clearcoat_roughness, clearcoat_map, clearcoat_roughness_map,
            clearcoat_normal_map, clearcoat_normal_scale, alpha_cutoff, blend, double_sided, unlit);
    if (extensions) add(*extensions);  // skipped if absent, so that existing scenes keep their fingerprint
  }
  void add(const SurfaceExtensions& extensions) {
    const auto& [sheen, anisotropy, iridescence, diffuse_transmission, volume, dispersion] = extensions;
    add_all(sheen, anisotropy, iridescence, diffuse_transmission, dispersion);
    add_optional(volume);
  }
  void add(const Sheen& sheen) {
    const auto& [color, color_map, roughness, roughness_map] = sheen;
    add_all(color, color_map, roughness, roughness_map);
  }
  void add(const Anisotropy& anisotropy) {
    const auto& [strength, rotation, map] = anisotropy;
    add_all(strength, rotation, map);
  }
  void add(const Iridescence& iridescence) {
    const auto& [share, map, ior, least_thickness_nm, most_thickness_nm, thickness_map] = iridescence;
    add_all(share, map, ior, least_thickness_nm, most_thickness_nm, thickness_map);
  }
  void add(const DiffuseTransmission& transmission) {
    const auto& [share, map, color, color_map] = transmission;
    add_all(share, map, color, color_map);
  }
  void add(const Volume& volume) {
    const auto& [is_solid, attenuation_color, attenuation_distance] = volume;
    add_all(is_solid, attenuation_color, attenuation_distance);
  }
  void add(const Material& material) {
    const auto& [name, surface] = material;
    print_.add(surface.index());
    std::visit([&](const auto& s) { add(s); }, surface);
  }

  void add(const Light& light) {
    const auto& [name, kind, node, color, attenuation, inverse_square, range, inner_cone, outer_cone, visible_radius, radius,
                 angular_diameter, smooth_edge, web] = light;
    add_all(kind, node, color, attenuation, inverse_square, range, inner_cone, outer_cone, visible_radius);
    // Skipped if unset, so that existing scenes keep their fingerprint
    if (radius > 0.0f || angular_diameter > 0.0f || smooth_edge) add_all(radius, angular_diameter, smooth_edge);
    if (web >= 0) add_all(web);
  }
  void add(const PhotometricWeb& web) {
    const auto& [name, polar, azimuth, intensity, web_from_light] = web;
    add_packed(polar), add_packed(azimuth), add_packed(intensity);
    add_all(web_from_light[0], web_from_light[1], web_from_light[2]);
  }
  void add(const Background& background) {
    const auto& [horizon, zenith, up, horizon_at, zenith_at, map] = background;
    add_all(horizon, zenith, up, horizon_at, zenith_at);
    add_optional(map);
  }
  void add(const EnvironmentMap& map) {
    const auto& [radiance, strength, rotation] = map;
    add_all(radiance.width, radiance.height, strength, rotation);
    add_packed(radiance.data);
  }
  void add(const Camera& camera) {
    const auto& [name, node, vertical_fov, aspect, focus_distance, pixel_offset, orthographic_height, near, shift] = camera;
    add_all(node, vertical_fov, aspect, focus_distance, pixel_offset);
    if (orthographic_height > 0.0f) add(orthographic_height);
    if (near > 0.0f) add(near);
    if (shift != Vec2f(0.0f)) add(shift);
  }
  void add(const DisplayPlacement& display) {
    const auto& [node, plane_height, viewing_distance] = display;
    add_all(node, plane_height, viewing_distance);
  }

  void add(const Transform& transform) {
    const auto& [translation, rotation, scale] = transform;
    add_all(translation, rotation, scale);
  }
  void add(const Node& node) {
    const auto& [name, parent, local, matrix, morph_weights] = node;
    add_all(parent, local);
    add_optional(matrix);
    add_packed(morph_weights);
  }
  void add(const Skin& skin) {
    const auto& [name, joints, joint_from_mesh] = skin;
    add_packed(joints);
    add_each(joint_from_mesh);
  }
  template <class T>
  void add(const Channel<T>& channel) {
    const auto& [times, values, interpolation] = channel;
    add_packed(times);
    add_packed(values);
    add(interpolation);
  }
  void add(const NodeAnimation& animation) {
    const auto& [node, translation, rotation, scale, morph_weights] = animation;
    add_all(node, translation, rotation, scale, morph_weights);
  }
  void add(const Timeline& timeline) {
    const auto& [frames_per_second, frame_count, animations] = timeline;
    add_all(frames_per_second, frame_count);
    add_each(animations);
  }
  void add(const Instance& instance) {
    const auto& [name, shape, material, node, skin, hidden_from_cameras, casts_no_shadow] = instance;
    add_all(shape, material, node, skin, hidden_from_cameras, casts_no_shadow);
  }

  Fingerprint print_;
};

}  // namespace

std::uint64_t fingerprint(const Scene& scene) {
  SceneFingerprint print;
  print.add(scene);
  return print.value();
}

}  // namespace lippmann
