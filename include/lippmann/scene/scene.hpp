// A scene as described by its file: shapes, materials, lights, cameras, a node hierarchy and its animation.
//
// Conventions for everything in this header:
// - Elements refer to each other by index into the Scene's vectors. Index -1 means none.
// - World space is right-handed. Lengths are in the file's own units.
// - Colours are linear and scene-referred unless Scene::encoding says otherwise.
// - Texture row 0 is the top row. Texture coordinate v grows downwards, as in glTF.
// - The coordinates of a shape are local to the node of the instance that shows it.
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

/// A morph target: offsets of a mesh's vertices, multiplied by the target's weight (Node::morph_weights or its animation). Each
/// vector has one element per vertex, or is empty.
struct MorphTarget {
  std::vector<Vec3f> positions{}, normals{}, tangents{};
};

/// The joints that move each vertex of a mesh, and their weights. The entries of vertex v are v * per_vertex to (v + 1) *
/// per_vertex - 1.
struct SkinWeights {
  int per_vertex = 0;                   ///< number of joints per vertex; 0: the mesh cannot be skinned
  std::vector<std::uint32_t> joints{};  ///< indices into Skin::joints
  std::vector<float> weights{};         ///< >= 0; the weights of a vertex sum to 1
};

struct Mesh {
  std::vector<Vec3f> positions{};
  std::vector<Vec3f> normals{};  ///< per vertex, unit length; empty: triangles are flat-shaded
  std::vector<Vec2f> uvs{};      ///< per vertex; empty: the mesh has no texture coordinates
  /// Vertex indices, each < positions.size(). Vertices are counter-clockwise as seen from the front.
  std::vector<std::array<std::uint32_t, 3>> triangles{};
  std::vector<Vec3f> colors{};  ///< per vertex; multiply the material's color; empty: white
  std::vector<float> alphas{};  ///< per vertex; multiply the material's alpha; empty: 1
  std::vector<Vec2f> uvs_1{};   ///< second set of texture coordinates, per vertex; empty: none
  /// Unit tangent (x, y, z) of each vertex, with w = +-1. The bitangent is w * (normal x tangent). Empty: derived from uvs.
  std::vector<Vec4f> tangents{};
  std::vector<MorphTarget> targets{};  ///< morph targets, which are applied before the skin
  SkinWeights skin{};
};

inline const std::vector<Vec2f>& uvs_of(const Mesh& mesh, int set) { return set == 0 ? mesh.uvs : mesh.uvs_1; }

struct Sphere {
  Vec3f center{0.0f};
  float radius = 1.0f;  ///< > 0
};

/// The side of a cylinder, without caps.
struct Cylinder {
  Vec3f base{0.0f};
  Vec3f apex{0.0f, 1.0f, 0.0f};
  float radius = 1.0f;  ///< > 0
};

/// An infinite plane. Rays hit both sides.
struct Plane {
  Vec3f point{0.0f};
  Vec3f normal{0.0f, 1.0f, 0.0f};  ///< unit length
};

/// A flat ring, or a disc if inner_radius is 0. Rays hit both sides.
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

/// 3D Gaussians that emit their own colours. Along a ray, splat i covers the fraction opacities[i] * exp(-d^2 / 2) of
/// everything behind it, where d is the smallest distance between the ray and the splat's centre, in standard deviations. All
/// vectors except `harmonics` have one element per splat.
struct Splats {
  std::vector<Vec3f> centers{};
  std::vector<Quatf> rotations{};   ///< unit length; rotates the splat's principal axes into the shape's axes
  std::vector<Vec3f> deviations{};  ///< standard deviations along the splat's three principal axes, > 0
  std::vector<float> opacities{};   ///< 0 to 1
  int degree = 0;                   ///< degree of the spherical harmonics, 0 to 3
  /// (degree + 1)^2 coefficients for each splat, ordered by l and then by m from -l to l. The colour of a splat is max(0, 0.5 +
  /// sum of coefficient * basis function). The basis functions are the real spherical harmonics with the Condon-Shortley phase,
  /// at the ray's direction in the shape's axes.
  std::vector<Vec3f> harmonics{};
  /// True: colours are linear. False: colours are sRGB-encoded, and splats are also blended in that encoding.
  bool is_linear = false;
};

using Spheres = std::vector<Sphere>;
using Cylinders = std::vector<Cylinder>;
using Planes = std::vector<Plane>;
using Rings = std::vector<Ring>;
using Boxes = std::vector<Box>;

/// Analytic shapes are intersected exactly. The transforms of their nodes must scale uniformly. Splats ignore their material.
using Shape = std::variant<Mesh, Spheres, Cylinders, Planes, Rings, Boxes, Splats>;

enum class Wrap { kRepeat, kMirror, kClamp };

struct Texture {
  std::string name{};
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba{};  ///< 4 bytes per texel, rows top to bottom
  bool srgb = true;                  ///< true: R, G and B are sRGB-encoded; false: linear, byte / 255
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
};

enum class ProjectionKind {
  kPlane,     ///< u and v run along u_axis and v_axis (Tachyon's TEXFUNC 9)
  kCylinder,  ///< u runs around v_axis, v along v_axis (TEXFUNC 7)
  kSphere,    ///< u runs around v_axis, v from 0 at the -v_axis pole to 1 at the +v_axis pole (TEXFUNC 8)
};

/// Projects a texture onto the surfaces of a material, as Tachyon's image maps do (formulas: shading/projection.hpp).
struct ImageProjection {
  ProjectionKind kind = ProjectionKind::kPlane;
  Vec3f center{0.0f}, rotate{0.0f}, scale{1.0f};
  Vec3f u_axis{1.0f, 0.0f, 0.0f}, v_axis{0.0f, 1.0f, 0.0f};  ///< orthonormal for kCylinder and kSphere
};

enum class Highlight {
  kNone,
  kPlastic,  ///< the highlight has the light's colour
  kMetal,    ///< the highlight has the surface's colour
};

/// The Phong surface of Whitted ray tracing. Its radiance, as in Tachyon, is the sum of:
/// - color * (ambient + diffuse * sum over the lights of N.L),
/// - highlight * sum over the lights of (N.H)^highlight_size,
/// - mirror * reflected radiance,
/// - (1 - opacity) * transmitted radiance,
/// - emission.
struct PhongSurface {
  Vec3f color{0.8f};
  int texture = -1;  ///< a projected texture replaces `color`, and a texture mapped by uv multiplies it
  std::optional<ImageProjection> projection{};  ///< none: the texture is mapped by the mesh's uvs
  float ambient = 0.1f, diffuse = 0.9f;
  Highlight highlight_kind = Highlight::kNone;
  float highlight = 0.0f, highlight_size = 1.0f;
  float mirror = 0.0f;   ///< fraction of the radiance from the mirror direction
  float opacity = 1.0f;  ///< 1: opaque; otherwise, the radiance from behind is transmitted, times 1 - opacity
  float ior = 1.0f;      ///< index of refraction for transmitted light; 1: no refraction
  Vec3f emission{0.0f};
};

/// A texture with its texture coordinates (glTF's KHR_texture_transform). The texture is looked up at offset + matrix * uv.
struct TextureMap {
  int texture = -1;  ///< index of the texture; -1: none, equivalent to a white texture
  int uv_set = 0;    ///< 0: uv is from Mesh::uvs; 1: from Mesh::uvs_1
  glm::mat2 matrix{1.0f};
  Vec2f offset{0.0f};
};

/// Fibres that scatter light at grazing angles (KHR_materials_sheen), above all layers except the clear coat.
struct Sheen {
  Vec3f color{0.0f};  ///< black: no sheen
  TextureMap color_map{};
  float roughness = 0.0f;
  TextureMap roughness_map{};  ///< channel A multiplies roughness
};

/// Anisotropic gloss: rougher along one direction of the surface (KHR_materials_anisotropy).
struct Anisotropy {
  float strength = 0.0f;  ///< 0 to 1: extra roughness along the rougher direction
  float rotation = 0.0f;  ///< angle of the rougher direction, in radians from the tangent towards the bitangent
  /// Channels R and G store (direction + 1) / 2, where direction is the rougher direction before `rotation`. Channel B
  /// multiplies `strength`.
  TextureMap map{};
};

/// A thin film that causes interference colours (KHR_materials_iridescence).
struct Iridescence {
  float share = 0.0f;  ///< fraction of the surface that the film covers, 0 to 1
  TextureMap map{};    ///< channel R multiplies share
  float ior = 1.3f;
  float least_thickness_nm = 100.0f, most_thickness_nm = 400.0f;
  /// Channel G interpolates from the smallest to the largest thickness. Without a texture, the film has the largest thickness.
  TextureMap thickness_map{};
};

/// Light that enters on one side and leaves diffusely on the other (KHR_materials_diffuse_transmission).
struct DiffuseTransmission {
  float share = 0.0f;  ///< fraction of the diffuse light that passes through, 0 to 1
  TextureMap map{};    ///< channel A multiplies share
  Vec3f color{1.0f};
  TextureMap color_map{};
};

/// The medium behind a transmissive surface (KHR_materials_volume).
struct Volume {
  bool is_solid = false;                   ///< true: a closed, filled shape; false: a thin wall, which does not refract light
  Vec3f attenuation_color{1.0f};           ///< colour that white light has after the attenuation distance
  float attenuation_distance = kInfinity;  ///< distance that gives attenuation_color, in world units
};

/// Rarely used glTF material extensions.
struct SurfaceExtensions {
  Sheen sheen{};
  Anisotropy anisotropy{};
  Iridescence iridescence{};
  DiffuseTransmission diffuse_transmission{};
  std::optional<Volume> volume{};  ///< none: transmissive surfaces refract light like closed shapes, without absorption
  float dispersion = 0.0f;         ///< 20 / Abbe number; 0: all colours are refracted equally
};

/// glTF 2.0's metallic-roughness model with the extensions listed in docs/reference/gltf.md. Each map multiplies the factor
/// declared before it. Colour maps are sRGB textures; all other maps are linear.
struct MetallicRoughness {
  Vec4f base_color{1.0f};
  TextureMap base_color_map{};
  float metallic = 1.0f, roughness = 1.0f;
  TextureMap metallic_roughness_map{};  ///< channel G: roughness, channel B: metallic
  /// RGB = (n + 1) / 2, where n is the normal in tangent space. The bitangent points upwards in the texture, against v.
  TextureMap normal_map{};
  float normal_scale = 1.0f;        ///< multiplies x and y of n
  TextureMap occlusion_map{};       ///< channel R: fraction of the ambient light that reaches the surface
  float occlusion_strength = 1.0f;  ///< the ambient light is multiplied by 1 + strength * (R - 1)
  Vec3f emissive{0.0f};
  TextureMap emissive_map{};
  float ior = 1.5f;
  float transmission = 0.0f;
  TextureMap transmission_map{};  ///< channel R multiplies transmission
  float specular = 1.0f;          ///< strength of the dielectric reflection
  TextureMap specular_map{};      ///< channel A multiplies specular
  Vec3f specular_color{1.0f};     ///< colour of the dielectric reflection at normal incidence; may exceed 1
  TextureMap specular_color_map{};
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
  TextureMap clearcoat_map{};            ///< channel R multiplies clearcoat
  TextureMap clearcoat_roughness_map{};  ///< channel G multiplies clearcoat_roughness
  /// Encoded like normal_map. Without a texture, the coat uses the surface normal without normal_map.
  TextureMap clearcoat_normal_map{};
  float clearcoat_normal_scale = 1.0f;
  float alpha_cutoff = 0.0f;  ///< mask mode: surfaces with a smaller alpha are invisible; 0: no mask
  bool blend = false;         ///< blend mode: alpha is the fraction of the surface that is opaque
  bool double_sided = false;
  bool unlit = false;
  std::optional<SurfaceExtensions> extensions{};
};

struct Material {
  std::string name{};
  std::variant<PhongSurface, MetallicRoughness> surface{};
};

enum class LightKind { kPoint, kDirectional, kSpot };

/// Measured angular distribution of a lamp's light (IES LM-63), interpolated linearly on a grid of polar angles and azimuths.
/// Directions outside the grid get no light.
struct PhotometricWeb {
  std::string name{};
  std::vector<float> polar{};  ///< radians from the web's +z; at least two values, increasing, within 0 to pi
  /// Radians from the web's +x towards +y; increasing, within -pi to 2 pi. One value: the light is rotationally symmetric.
  std::vector<float> azimuth{};
  /// One value, >= 0, per azimuth and polar angle; all polar angles of the first azimuth come first. The mean over the sphere
  /// is 1.
  std::vector<float> intensity{};
  /// Maps directions from the axes of the light, which shines along -z, to the axes of the web.
  Mat3f web_from_light{1.0f};
};

/// A light shines from its node's origin. Directional and spot lights shine along the node's -z.
struct Light {
  std::string name{};
  LightKind kind = LightKind::kPoint;
  int node = -1;
  /// Colour times intensity. Diffuse surfaces multiply it by N.L; metallic-roughness surfaces also by albedo / pi.
  Vec3f color{1.0f};
  /// Point and spot lights: at distance d, the light is divided by x + y * d + z * d^2 (x, y and z of this vector), as in
  /// Tachyon.
  Vec3f attenuation{1.0f, 0.0f, 0.0f};
  /// Point and spot lights: whether the light is also divided by the squared distance, as in glTF.
  bool inverse_square = false;
  float range = kInfinity;     ///< the light does not reach beyond this distance
  float inner_cone = 0.0f;     ///< spot lights: half angle in radians of the cone with full strength
  float outer_cone = kPi / 4;  ///< spot lights: half angle in radians of the cone that contains all light
  /// If > 0, the light is visible as a sphere of this radius in the light's colour. The sphere casts no shadow.
  float visible_radius = 0.0f;
  /// The size of the emitter, by which path tracing softens shadows. It changes neither the power of a lamp nor the light at
  /// points without shadow. Mirrors show the emitter, but cameras do not.
  float radius = 0.0f;            ///< point and spot lights: radius in world units; needs inverse_square
  float angular_diameter = 0.0f;  ///< directional lights: angular diameter of the disc in radians, at most pi
  /// Spot lights: the factor of the light between the two cones. true: 3 t^2 - 2 t^3, as in Blender. false: t^2. t is linear in
  /// the cosine of the angle, 1 at the inner cone and 0 at the outer cone.
  bool smooth_edge = false;
  /// Point lights: index into Scene::webs. The intensity of the web multiplies the colour. -1: the light is the same in all
  /// directions.
  int web = -1;
};

/// A panorama that surrounds the scene, oriented as in transport/environment.hpp.
struct EnvironmentMap {
  static constexpr int kMostWidth = 32768, kMostHeight = 16384;
  Image radiance{};  ///< 3 channels, linear, finite and >= 0; equirectangular
  float strength = 1.0f;
  float rotation = 0.0f;  ///< rotation about +y in radians, from +x towards +z
};

/// Radiance of rays that hit nothing: the map if there is one, otherwise `horizon` where dot(direction, up) <= horizon_at,
/// `zenith` where dot(direction, up) >= zenith_at, and a linear blend in between.
struct Background {
  Vec3f horizon{0.0f};
  Vec3f zenith{0.0f};
  Vec3f up{0.0f, 1.0f, 0.0f};  ///< unit length
  /// Sines of the elevations at which the blend begins and ends. They must differ. If horizon_at > zenith_at, the horizon
  /// colour is above the zenith colour.
  float horizon_at = 0.0f, zenith_at = 1.0f;
  std::optional<EnvironmentMap> map{};
};

/// A camera at its node's origin, which looks along the node's -z with +y up.
struct Camera {
  std::string name{};
  int node = -1;
  float vertical_fov = radians(45.0f);  ///< full vertical angle in radians
  float aspect = 1.0f;                  ///< width / height of the image that the file requests; 0: unknown
  float focus_distance = 0.0f;          ///< distance of the plane that the author wants in focus, in node units; 0: none
  /// Shifts the ray of each pixel by this many pixels (x right, y down). Only for single views.
  Vec2f pixel_offset{0.0f};
  /// If > 0, the camera is orthographic and shows this height in node units. vertical_fov is ignored.
  float orthographic_height = 0.0f;
  float near_distance = 0.0f;  ///< distance of the near clipping plane, in node units
  /// Moves the image rectangle on the image plane to the right and up, in units of the image height. Only for single views.
  Vec2f shift{0.0f};
};

/// The author's placement of the lens array. The array lies in the plane z = 0 of the node, with +z towards the viewer and +y
/// up.
struct DisplayPlacement {
  int node = -1;
  float plane_height = 1.0f;           ///< height of the array in node units
  float viewing_distance = kInfinity;  ///< distance of the viewer from the array, in node units
};

struct Transform {
  Vec3f translation{0.0f};
  Quatf rotation{1.0f, 0.0f, 0.0f, 0.0f};
  Vec3f scale{1.0f};
};

struct Node {
  std::string name{};
  int parent = -1;  ///< less than the node's own index, so that parents come first
  Transform local{};
  /// Replaces `local` for nodes that have a matrix in glTF. Such a node cannot be animated.
  std::optional<Affine3f> matrix{};
  std::vector<float> morph_weights{};  ///< default weights, one per morph target of the node's meshes
};

/// A skeleton. A skinned mesh follows its joints and ignores the node of its instance. Vertex v moves to the sum over its
/// joints j of weight_j * world_from_node[joints[j]] * joint_from_mesh[j] * v.
struct Skin {
  std::string name{};
  std::vector<int> joints{};                ///< indices of the joints' nodes
  std::vector<Affine3f> joint_from_mesh{};  ///< inverse bind matrix of each joint
};

enum class Interpolation { kStep, kLinear, kCubicSpline };

/// Keyframes of one animated quantity, which is constant before the first key and after the last one.
template <class T>
struct Channel {
  std::vector<double> times{};  ///< in seconds, strictly increasing; empty: the quantity is not animated
  /// One value per key. kCubicSpline has three values per key: in-tangent, value, out-tangent.
  std::vector<T> values{};
  Interpolation interpolation = Interpolation::kLinear;
};

struct NodeAnimation {
  int node = -1;
  Channel<Vec3f> translation{};
  Channel<Quatf> rotation{};  ///< kLinear: spherical interpolation along the shorter arc
  Channel<Vec3f> scale{};
  Channel<float> morph_weights{};  ///< each key has one value per morph weight of the node
};

/// Frame f shows the scene at the time f / frames_per_second, in seconds.
struct Timeline {
  double frames_per_second = 25.0;
  int frame_count = 1;
  std::vector<NodeAnimation> animations{};  ///< at most one element per node
  double time(int frame) const { return frame / frames_per_second; }
};

/// A shape with a material at a node. The index in Scene::instances is the instance's object id.
struct Instance {
  std::string name{};
  int shape = -1, material = -1, node = -1;
  /// Index of the skin that moves the mesh instead of the node. The mesh must have SkinWeights. -1: not skinned.
  int skin = -1;
  /// Meshes only: camera rays pass through the instance, but mirrors show it, and it still emits light.
  bool hidden_from_cameras = false;
  /// True: the instance casts no shadow. Shapes other than meshes may set this only if no instance of the scene casts shadows.
  bool casts_no_shadow = false;
};

/// The shading model of a scene, which selects the default sampling.
enum class SceneKind {
  /// Physically based materials and lights: glTF, OBJ and PLY files, and scenes made in memory.
  kPhysical,
  /// Whitted shading: the built-in scenes, and NFF and Tachyon files.
  kWhitted,
  /// Splats only. Their colours include the lighting.
  kSplats,
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
  std::vector<Camera> cameras{};  ///< the first camera is the default
  /// Placement of the lens array. None: the array is fitted to the first camera (stage/fit_array.hpp).
  std::optional<DisplayPlacement> display{};
  Background background{};
  Timeline timeline{};
  std::vector<std::string> animation_names{};  ///< names of all animations of the file
  int animation = -1;                          ///< index into animation_names of the animation that `timeline` contains
  std::vector<std::string> variant_names{};
  /// A point p of the scene lies at origin + p in the file (scene/origin.hpp).
  Vec3d origin{0.0};
  Encoding encoding = Encoding::kSrgb;
  int max_depth = 6;       ///< maximum number of vertices of a path; 6 unless the file states a limit
  Vec2i resolution{0, 0};  ///< image width and height that the file requests; 0: none
  SceneKind kind = SceneKind::kPhysical;

  // The add functions append one element and return its index.
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
