// A scene as described by its file: shapes, materials, lights, cameras, a node hierarchy and its animation. Plain data.
//
// Conventions for everything in this header. Elements refer to each other by index into the Scene's vectors; -1 means none.
// World space is right-handed; lengths are in the file's own units. Colours are linear and scene-referred unless the scene's
// `encoding` differs. Texture row 0 is the top row; texture coordinate v grows downwards (as in glTF); textures repeat or clamp
// according to their wrap mode. A shape's coordinates are local to the node of the instance that shows it.
// trace/device_scene.hpp builds the structures for ray tracing from a Scene; scene/timeline.hpp evaluates it at a given time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

// ---- Shapes ---------------------------------------------------------------------------------------------------------

/// Offsets that morphing adds to a mesh, per vertex, times the weight from Node::morph_weights or its animation. Each vector
/// may be empty.
struct MorphTarget {
  std::vector<Vec3f> positions{}, normals{}, tangents{};
};

/// The joints of the instance's Skin that carry each vertex, and their weights. Vertex v has the entries from v * per_vertex
/// on.
struct SkinWeights {
  int per_vertex = 0;                   ///< 0: the mesh cannot be skinned
  std::vector<std::uint32_t> joints{};  ///< indices into Skin::joints
  std::vector<float> weights{};         ///< >= 0; the weights of a vertex sum to 1
};

struct Mesh {
  std::vector<Vec3f> positions{};
  std::vector<Vec3f> normals{};  ///< per vertex, unit length; empty: faceted
  std::vector<Vec2f> uvs{};      ///< per vertex; empty: no texture coordinates
  std::vector<std::array<std::uint32_t, 3>>
      triangles{};              ///< vertex indices, each < positions.size(); counter-clockwise = front
  std::vector<Vec3f> colors{};  ///< per vertex; multiply the material's color; empty: white
  std::vector<float> alphas{};  ///< per vertex; multiply the material's alpha; empty: 1
  std::vector<Vec2f> uvs_1{};   ///< the second set of texture coordinates; empty: none
  std::vector<Vec4f>
      tangents{};  ///< per vertex: unit tangent and w = +-1; the bitangent is w (normal x tangent); empty: derived from uvs
  std::vector<MorphTarget> targets{};  ///< applied before the skin
  SkinWeights skin{};
};

/// Returns set 0 or 1 of a mesh's texture coordinates.
inline const std::vector<Vec2f>& uvs_of(const Mesh& mesh, int set) { return set == 0 ? mesh.uvs : mesh.uvs_1; }

struct Sphere {
  Vec3f center{0.0f};
  float radius = 1.0f;  ///< > 0
};

/// The open side surface between base and apex; no caps.
struct Cylinder {
  Vec3f base{0.0f};
  Vec3f apex{0.0f, 1.0f, 0.0f};
  float radius = 1.0f;  ///< > 0
};

/// An infinite two-sided plane.
struct Plane {
  Vec3f point{0.0f};
  Vec3f normal{0.0f, 1.0f, 0.0f};  ///< unit length
};

/// A flat ring (a disc where inner_radius is 0), two-sided.
struct Ring {
  Vec3f center{0.0f};
  Vec3f normal{0.0f, 1.0f, 0.0f};  ///< unit length
  float inner_radius = 0.0f;
  float outer_radius = 1.0f;
};

/// A box aligned with the local axes.
struct Box {
  Vec3f lower{-1.0f};
  Vec3f upper{1.0f};
};

/// 3D Gaussians that emit their own colours: a captured scene, as trained on photographs. Along a ray, splat i covers
/// opacities[i] * exp(-d^2 / 2) of everything behind it, where d is the smallest distance of the ray from its centre in
/// standard deviations. All vectors except `harmonics` have one element per splat.
struct Splats {
  std::vector<Vec3f> centers{};
  std::vector<Quatf> rotations{};   ///< unit length: rotate from the axes of the deviations to the axes of the shape
  std::vector<Vec3f> deviations{};  ///< standard deviations along its three axes, > 0
  std::vector<float> opacities{};   ///< 0 to 1
  int degree = 0;                   ///< of the spherical harmonics, 0 to 3
  /// (degree + 1)^2 for each splat, ordered by l and then by m from -l to l. A colour is max(0, 0.5 + sum of harmonics * basis
  /// function at the ray's direction in the shape's axes). The basis is real, with the Condon-Shortley phase.
  std::vector<Vec3f> harmonics{};
  bool is_linear =
      false;  ///< true: colours are linear light; false: sRGB-encoded, and splats are also blended in that encoding
};

using Spheres = std::vector<Sphere>;
using Cylinders = std::vector<Cylinder>;
using Planes = std::vector<Plane>;
using Rings = std::vector<Ring>;
using Boxes = std::vector<Box>;

/// Analytic shapes are intersected exactly, never tessellated; the transforms above them must scale uniformly. Splats are unlit
/// and ignore their material.
using Shape = std::variant<Mesh, Spheres, Cylinders, Planes, Rings, Boxes, Splats>;

// ---- Materials ------------------------------------------------------------------------------------------------------

enum class Wrap { kRepeat, kMirror, kClamp };

struct Texture {
  std::string name{};
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba{};  ///< 4 bytes per texel, rows top to bottom
  bool srgb = true;                  ///< R, G, B are sRGB-encoded; false: the byte / 255 is the value
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
};

enum class ProjectionKind {
  kPlane,     ///< u and v along u_axis and v_axis (Tachyon's TEXFUNC 9)
  kCylinder,  ///< u around v_axis, v along it (TEXFUNC 7)
  kSphere,    ///< u around v_axis, v from -v_axis (0) to v_axis (1) (TEXFUNC 8)
};

/// Projects a texture onto the surfaces of a material, as Tachyon's image maps do (formulas: trace/projection.hpp).
struct ImageProjection {
  ProjectionKind kind = ProjectionKind::kPlane;
  Vec3f center{0.0f}, rotate{0.0f}, scale{1.0f};
  Vec3f u_axis{1.0f, 0.0f, 0.0f}, v_axis{0.0f, 1.0f, 0.0f};  ///< orthonormal for kCylinder and kSphere
};

enum class Highlight {
  kNone,
  kPlastic,  ///< in the light's colour
  kMetal,    ///< in the surface's colour
};

/// The Phong surface of Whitted ray tracing, as Tachyon computes it:
/// color (ambient + diffuse sum L N.L) + highlight sum (N.H)^highlight_size + mirror reflected + (1 - opacity) transmitted +
/// emission.
struct PhongSurface {
  Vec3f color{0.8f};
  int texture = -1;                             ///< replaces (projected) or multiplies (uv) color
  std::optional<ImageProjection> projection{};  ///< maps the texture; none: the mesh's uvs do
  float ambient = 0.1f, diffuse = 0.9f;
  Highlight highlight_kind = Highlight::kNone;
  float highlight = 0.0f, highlight_size = 1.0f;
  float mirror = 0.0f;   ///< share of the mirror direction's radiance
  float opacity = 1.0f;  ///< the share 1 - opacity of the radiance behind is transmitted
  float ior = 1.0f;      ///< refracts transmitted light; 1: no refraction
  Vec3f emission{0.0f};
};

/// A texture and its lookup: at offset + matrix * uv, for one of the mesh's uv sets (glTF's KHR_texture_transform).
struct TextureMap {
  int texture = -1;  ///< -1: none, read as white
  int uv_set = 0;    ///< 0: Mesh::uvs, 1: Mesh::uvs_1
  glm::mat2 matrix{1.0f};
  Vec2f offset{0.0f};
};

/// Fibres that scatter light at grazing angles, on top of all layers except the clear coat (KHR_materials_sheen).
struct Sheen {
  Vec3f color{0.0f};  ///< black: no sheen
  TextureMap color_map{};
  float roughness = 0.0f;
  TextureMap roughness_map{};  ///< channel A
};

/// Anisotropic gloss: rougher along one direction of the surface (KHR_materials_anisotropy).
struct Anisotropy {
  float strength = 0.0f;  ///< 0 to 1: extra roughness along the direction
  float rotation = 0.0f;  ///< radians from the tangent towards the bitangent
  TextureMap map{};       ///< RG = (direction + 1) / 2 before the rotation, B: strength
};

/// A thin film that causes interference colours (KHR_materials_iridescence).
struct Iridescence {
  float share = 0.0f;  ///< share of the surface that has the film, 0 to 1
  TextureMap map{};    ///< channel R
  float ior = 1.3f;
  float least_thickness_nm = 100.0f, most_thickness_nm = 400.0f;
  TextureMap thickness_map{};  ///< G: interpolates from the least to the most thickness; none: the most
};

/// Light that enters on one side and leaves diffusely on the other (KHR_materials_diffuse_transmission).
struct DiffuseTransmission {
  float share = 0.0f;  ///< share of the diffuse light that passes through, 0 to 1
  TextureMap map{};    ///< channel A
  Vec3f color{1.0f};
  TextureMap color_map{};
};

/// The medium behind a transmissive surface (KHR_materials_volume).
struct Volume {
  bool is_solid = false;                   ///< true: a closed, filled shape; false: a thin wall, which does not refract
  Vec3f attenuation_color{1.0f};           ///< colour of white light after the attenuation distance
  float attenuation_distance = kInfinity;  ///< world units
};

/// Rarely used glTF material extensions.
struct SurfaceExtensions {
  Sheen sheen{};
  Anisotropy anisotropy{};
  Iridescence iridescence{};
  DiffuseTransmission diffuse_transmission{};
  std::optional<Volume> volume{};  ///< none: transmissive surfaces refract as closed shapes do, without absorption
  float dispersion = 0.0f;         ///< 20 / Abbe number; 0: all colours refract alike
};

/// glTF 2.0's metallic-roughness model with the extensions listed in docs/reference/gltf.md. Maps multiply the factors beside
/// them, using the channels named here. Colour maps are sRGB textures; all others are linear.
struct MetallicRoughness {
  Vec4f base_color{1.0f};
  TextureMap base_color_map{};
  float metallic = 1.0f, roughness = 1.0f;
  TextureMap metallic_roughness_map{};  ///< G: roughness, B: metallic
  TextureMap normal_map{};              ///< RGB = (n + 1) / 2 in tangent space; v grows downwards, the bitangent upwards
  float normal_scale = 1.0f;            ///< multiplies x and y of the map's normal
  TextureMap occlusion_map{};           ///< R: share of the ambient light that arrives
  float occlusion_strength = 1.0f;      ///< 1 + strength * (R - 1)
  Vec3f emissive{0.0f};
  TextureMap emissive_map{};
  float ior = 1.5f;
  float transmission = 0.0f;
  TextureMap transmission_map{};  ///< channel R
  float specular = 1.0f;          ///< strength of the dielectric reflection
  TextureMap specular_map{};      ///< channel A
  Vec3f specular_color{1.0f};     ///< colour of the dielectric reflection at normal incidence; may exceed 1
  TextureMap specular_color_map{};
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
  TextureMap clearcoat_map{};            ///< channel R
  TextureMap clearcoat_roughness_map{};  ///< channel G
  TextureMap clearcoat_normal_map{};     ///< like normal_map; none: the coat uses the surface normal without its normal map
  float clearcoat_normal_scale = 1.0f;
  float alpha_cutoff = 0.0f;  ///< mask mode: cuts away alpha below this; 0: no mask
  bool blend = false;         ///< blend mode: alpha is coverage
  bool double_sided = false;
  bool unlit = false;
  std::optional<SurfaceExtensions> extensions{};
};

struct Material {
  std::string name{};
  std::variant<PhongSurface, MetallicRoughness> surface{};
};

// ---- Lights, background, camera, display ----------------------------------------------------------------------------

enum class LightKind { kPoint, kDirectional, kSpot };

/// Angular distribution of a lamp's light as measured (IES LM-63): a grid of intensities over polar angles and azimuths,
/// interpolated linearly. Directions outside the grid get no light.
struct PhotometricWeb {
  std::string name{};
  std::vector<float> polar{};  ///< radians from the web's +z: at least two, increasing, within 0 to pi
  std::vector<float>
      azimuth{};  ///< radians from +x towards +y, increasing, within -pi to 2 pi; one value: rotationally symmetric
  std::vector<float> intensity{};  ///< by azimuth, then by polar angle, >= 0; relative: the mean over the sphere is 1
  Mat3f web_from_light{1.0f};      ///< a rotation, possibly mirrored; lights shine along -z
};

/// A light shines from its node's origin. Directional and spot lights shine along the node's -z.
struct Light {
  std::string name{};
  LightKind kind = LightKind::kPoint;
  int node = -1;
  Vec3f color{1.0f};  ///< colour times intensity; multiplies N.L (and albedo / pi for metallic-roughness surfaces)
  Vec3f attenuation{1.0f, 0.0f, 0.0f};  ///< point and spot: divide by x + y d + z d^2 at distance d (Tachyon)
  bool inverse_square =
      false;                ///< point and spot: divide by the squared distance (glTF); false: by `attenuation` alone (Tachyon)
  float range = kInfinity;  ///< no light beyond this distance
  float inner_cone = 0.0f;  ///< spot: full strength within this half angle
  float outer_cone = kPi / 4;   ///< spot: no light beyond this half angle
  float visible_radius = 0.0f;  ///< > 0: rays see the light as a sphere of its colour, which casts no shadow
  /// The size of the emitter, which softens shadows in path tracing; Whitted shading treats these lights as points. It changes
  /// neither the power of a lamp nor the light at points that see all of it. Camera rays do not see the emitter; mirrors do.
  float radius = 0.0f;            ///< point and spot: radius of the emitting sphere in world units; needs inverse_square
  float angular_diameter = 0.0f;  ///< directional: angular diameter of the emitting disc, in radians, at most pi
  bool smooth_edge = false;  ///< spot: true: fades by 3 t^2 - 2 t^3 between the cosines of its cones (Blender); false: by t^2
  int web = -1;  ///< point: index into Scene::webs, whose value multiplies the colour; -1: the same in all directions
};

/// A panorama around the scene. transport/environment.hpp defines its orientation.
struct EnvironmentMap {
  static constexpr int kMostWidth = 32768, kMostHeight = 16384;
  Image radiance{};  ///< 3 channels, linear, finite and >= 0; equirectangular
  float strength = 1.0f;
  float rotation = 0.0f;  ///< radians about +y, from +x towards +z
};

/// Radiance of rays that hit nothing: the map if there is one; else `horizon` where dot(direction, up) <= horizon_at, `zenith`
/// where it is >= zenith_at, and a linear blend in between.
struct Background {
  Vec3f horizon{0.0f};
  Vec3f zenith{0.0f};
  Vec3f up{0.0f, 1.0f, 0.0f};  ///< unit length
  float horizon_at = 0.0f,
        zenith_at = 1.0f;  ///< sines of elevation, which must differ; horizon_at > zenith_at turns the blend upside down
  std::optional<EnvironmentMap> map{};
};

/// Looks along its node's -z with +y up.
struct Camera {
  std::string name{};
  int node = -1;
  float vertical_fov = radians(45.0f);  ///< full angle in radians
  float aspect = 1.0f;                  ///< width / height requested by the file; 0: unknown
  float focus_distance = 0.0f;          ///< > 0: distance of the author's plane of interest, in node units
  Vec2f pixel_offset{0.0f};             ///< shifts the sample points of single views by this many pixels (x right, y down)
  float orthographic_height = 0.0f;     ///< > 0: orthographic, showing this height in node units; vertical_fov is ignored
};

/// The author's placement of the lens array: the plane z = 0 of the node, +z towards the viewer, +y up.
struct DisplayPlacement {
  int node = -1;
  float plane_height = 1.0f;           ///< height of the array in node units
  float viewing_distance = kInfinity;  ///< distance from the array to the point that its cells converge to, in node units
};

// ---- Nodes and time -------------------------------------------------------------------------------------------------

/// Scales, then rotates, then translates.
struct Transform {
  Vec3f translation{0.0f};
  Quatf rotation{1.0f, 0.0f, 0.0f, 0.0f};
  Vec3f scale{1.0f};
};

struct Node {
  std::string name{};
  int parent = -1;  ///< less than the node's own index: parents come first
  Transform local{};
  std::optional<Affine3f> matrix{};    ///< replaces `local` (glTF matrix nodes); such a node cannot be animated
  std::vector<float> morph_weights{};  ///< default weights, one per morph target of the meshes shown here
};

/// A skeleton. A skinned mesh follows its joints and ignores the node of its instance. Vertex v lies at the sum over its
/// weights w_j of w_j (world_from_node[joints[j]] * joint_from_mesh[j]) v.
struct Skin {
  std::string name{};
  std::vector<int> joints{};                ///< node indices
  std::vector<Affine3f> joint_from_mesh{};  ///< per joint: the inverse bind matrix
};

enum class Interpolation { kStep, kLinear, kCubicSpline };

/// Keyframes of one animated quantity. The first value holds before the first key, the last one after the last key.
template <class T>
struct Channel {
  std::vector<double> times{};  ///< seconds, strictly increasing; empty: not animated
  std::vector<T> values{};      ///< one per key; for kCubicSpline three: in-tangent, value, out-tangent
  Interpolation interpolation = Interpolation::kLinear;
};

struct NodeAnimation {
  int node = -1;
  Channel<Vec3f> translation{};
  Channel<Quatf> rotation{};  ///< linear: spherical interpolation along the shorter arc
  Channel<Vec3f> scale{};
  Channel<float> morph_weights{};  ///< per key, one value for each of the node's morph weights
};

/// Frame f shows the time f / frames_per_second.
struct Timeline {
  double frames_per_second = 25.0;
  int frame_count = 1;
  std::vector<NodeAnimation> animations{};  ///< at most one per node
  double time(int frame) const { return frame / frames_per_second; }
};

// ---- The scene ------------------------------------------------------------------------------------------------------

/// Shows a shape with a material at a node. Its index in Scene::instances is its object id.
struct Instance {
  std::string name{};
  int shape = -1, material = -1, node = -1;
  int skin = -1;                     ///< index of a skin that moves the mesh instead of the node; the mesh needs SkinWeights
  bool hidden_from_cameras = false;  ///< meshes only: camera rays pass through it, but mirrors show it and it emits light
  bool casts_no_shadow = false;      ///< meshes; other shapes only if no instance of the scene casts shadows
};

/// The shading model of a scene's materials and lights. It selects the default sampling: see completed() in
/// frames/frame_params.hpp.
enum class SceneKind {
  kPhysical,  ///< physically based materials and light: glTF, OBJ and PLY files, and scenes made in memory
  kWhitted,   ///< Whitted shading: the built-in scenes, and NFF and Tachyon files
  kSplats,    ///< splats only, whose colours include their lighting
};

struct Scene {
  std::string name{};
  std::vector<Node> nodes{};
  std::vector<Shape> shapes{};
  std::vector<Texture> textures{};
  std::vector<Material> materials{};
  std::vector<Instance> instances{};
  std::vector<Skin> skins{};
  std::vector<Light> lights{};
  std::vector<PhotometricWeb> webs{};
  std::vector<Camera> cameras{};              ///< the first is the default
  std::optional<DisplayPlacement> display{};  ///< none: fitted to the first camera (stage/fit_array.hpp)
  Background background{};
  Timeline timeline{};
  std::vector<std::string> animation_names{};  ///< all animations of the file
  int animation = -1;                          ///< index of the animation in `timeline`
  std::vector<std::string> variant_names{};    ///< the file's material variants
  Vec3d origin{0.0};  ///< of the scene's coordinates, in file coordinates: a point p of the scene lies at origin + p in the
                      ///< file (scene/origin.hpp)
  Encoding encoding = Encoding::kSrgb;
  int max_depth = 6;       ///< longest path in vertices; the file's own limit if it has one
  Vec2i resolution{0, 0};  ///< requested by the file; 0: none
  SceneKind kind = SceneKind::kPhysical;

  // Each appends one element and returns its index, by which others refer to it.
  int add_node(Node node) { return added(nodes, std::move(node)); }
  int add_shape(Shape shape) { return added(shapes, std::move(shape)); }
  int add_mesh(Mesh mesh) { return add_shape(std::move(mesh)); }
  int add_material(Material material) { return added(materials, std::move(material)); }
  int add_instance(Instance instance) { return added(instances, std::move(instance)); }

 private:
  template <class T>
  static int added(std::vector<T>& list, T element) {
    list.push_back(std::move(element));
    return static_cast<int>(list.size()) - 1;
  }
};

}  // namespace lippmann
