// A scene as described by its file: shapes, materials, lights, cameras, a node hierarchy and its animation. Plain data.
//
// Conventions for everything in this header: elements refer to each other by index into the Scene's vectors, where -1 means
// none. World space is right-handed; lengths are in the file's own units. Colours are linear and scene-referred unless the
// scene's `encoding` differs. Texture row 0 is the top row; texture coordinate v grows downwards (as in glTF); textures repeat
// or clamp according to their wrap mode. A shape's coordinates are local to the node of the instance that shows it.
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

/// Offsets that morphing adds to each vertex of a mesh, multiplied by the weight from Node::morph_weights or its animation.
/// Each vector may be empty.
struct MorphTarget {
  std::vector<Vec3f> positions{}, normals{}, tangents{};
};

/// The joints of the instance's Skin that carry each vertex, and their weights. Vertex v has the entries v * per_vertex ... (v
/// + 1) * per_vertex - 1.
struct SkinWeights {
  int per_vertex = 0;                   ///< 0: the mesh cannot be skinned
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
  std::vector<Vec2f> uvs_1{};   ///< the second set of texture coordinates; empty: none
  /// Per vertex: unit tangent and w = +-1; the bitangent is w (normal x tangent). Empty: derived from uvs.
  std::vector<Vec4f> tangents{};
  std::vector<MorphTarget> targets{};  ///< morphing is applied before the skin
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

/// A flat ring, or a disc if inner_radius is 0. Two-sided.
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

/// 3D Gaussians that emit their own colours: a captured scene, trained on photographs. Along a ray, splat i covers the share
/// opacities[i] * exp(-d^2 / 2) of everything behind it, where d is the smallest distance of the ray from the splat's centre in
/// standard deviations. All vectors except `harmonics` have one element per splat.
struct Splats {
  std::vector<Vec3f> centers{};
  std::vector<Quatf> rotations{};   ///< unit length: rotate from the axes of the deviations to the axes of the shape
  std::vector<Vec3f> deviations{};  ///< standard deviations along the splat's three axes, > 0
  std::vector<float> opacities{};   ///< 0 to 1
  int degree = 0;                   ///< degree of the spherical harmonics, 0 to 3
  /// (degree + 1)^2 coefficients for each splat, ordered by l and then by m from -l to l. A splat's colour is max(0, 0.5 + sum
  /// of coefficient * basis function), at the ray's direction in the shape's axes. The basis is real, with the Condon-Shortley
  /// phase.
  std::vector<Vec3f> harmonics{};
  /// True: colours are linear light. False: colours are sRGB-encoded, and splats are also blended in that encoding.
  bool is_linear = false;
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
  bool srgb = true;                  ///< R, G and B are sRGB-encoded; false: the value is the byte / 255
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
};

enum class ProjectionKind {
  kPlane,     ///< u and v run along u_axis and v_axis (Tachyon's TEXFUNC 9)
  kCylinder,  ///< u runs around v_axis, v along it (TEXFUNC 7)
  kSphere,    ///< u runs around v_axis, v from the -v_axis pole (0) to the v_axis pole (1) (TEXFUNC 8)
};

/// Projects a texture onto the surfaces of a material, as Tachyon's image maps do (formulas: trace/projection.hpp).
struct ImageProjection {
  ProjectionKind kind = ProjectionKind::kPlane;
  Vec3f center{0.0f}, rotate{0.0f}, scale{1.0f};
  Vec3f u_axis{1.0f, 0.0f, 0.0f}, v_axis{0.0f, 1.0f, 0.0f};  ///< orthonormal for kCylinder and kSphere
};

enum class Highlight {
  kNone,
  kPlastic,  ///< highlights have the light's colour
  kMetal,    ///< highlights have the surface's colour
};

/// The Phong surface of Whitted ray tracing, as Tachyon computes it:
/// color (ambient + diffuse sum L N.L) + highlight sum (N.H)^highlight_size + mirror reflected + (1 - opacity) transmitted +
/// emission.
struct PhongSurface {
  Vec3f color{0.8f};
  int texture = -1;                             ///< a projected texture replaces `color`; one mapped by uv multiplies it
  std::optional<ImageProjection> projection{};  ///< how the texture is projected; none: it is mapped by the mesh's uvs
  float ambient = 0.1f, diffuse = 0.9f;
  Highlight highlight_kind = Highlight::kNone;
  float highlight = 0.0f, highlight_size = 1.0f;
  float mirror = 0.0f;   ///< share of the radiance from the mirror direction
  float opacity = 1.0f;  ///< the share 1 - opacity of the radiance from behind is transmitted
  float ior = 1.0f;      ///< refracts transmitted light; 1: no refraction
  Vec3f emission{0.0f};
};

/// A texture that is looked up at offset + matrix * uv, for one of the mesh's uv sets (glTF's KHR_texture_transform).
struct TextureMap {
  int texture = -1;  ///< index of the texture; -1: none, which reads as white
  int uv_set = 0;    ///< set of texture coordinates: 0: Mesh::uvs, 1: Mesh::uvs_1
  glm::mat2 matrix{1.0f};
  Vec2f offset{0.0f};
};

/// Fibres that scatter light at grazing angles, on top of all layers except the clear coat (KHR_materials_sheen).
struct Sheen {
  Vec3f color{0.0f};  ///< black: there is no sheen
  TextureMap color_map{};
  float roughness = 0.0f;
  TextureMap roughness_map{};  ///< channel A multiplies roughness
};

/// Anisotropic gloss: rougher along one direction of the surface (KHR_materials_anisotropy).
struct Anisotropy {
  float strength = 0.0f;  ///< 0 to 1: extra roughness along the direction
  float rotation = 0.0f;  ///< angle from the tangent towards the bitangent, in radians
  TextureMap map{};       ///< channels R, G: (direction + 1) / 2 before the rotation; channel B: strength
};

/// A thin film that causes interference colours (KHR_materials_iridescence).
struct Iridescence {
  float share = 0.0f;  ///< share of the surface that has the film, 0 to 1
  TextureMap map{};    ///< channel R multiplies share
  float ior = 1.3f;
  float least_thickness_nm = 100.0f, most_thickness_nm = 400.0f;
  /// Channel G interpolates from the least to the most thickness; no texture: the most.
  TextureMap thickness_map{};
};

/// Light that enters on one side and leaves diffusely on the other (KHR_materials_diffuse_transmission).
struct DiffuseTransmission {
  float share = 0.0f;  ///< share of the diffuse light that passes through, 0 to 1
  TextureMap map{};    ///< channel A multiplies share
  Vec3f color{1.0f};
  TextureMap color_map{};
};

/// The medium behind a transmissive surface (KHR_materials_volume).
struct Volume {
  bool is_solid = false;                   ///< true: a closed, filled shape; false: a thin wall, which does not refract light
  Vec3f attenuation_color{1.0f};           ///< colour that white light has after the attenuation distance
  float attenuation_distance = kInfinity;  ///< in world units
};

/// Rarely used glTF material extensions.
struct SurfaceExtensions {
  Sheen sheen{};
  Anisotropy anisotropy{};
  Iridescence iridescence{};
  DiffuseTransmission diffuse_transmission{};
  std::optional<Volume> volume{};  ///< none: transmissive surfaces refract as closed shapes do, without absorption
  float dispersion = 0.0f;         ///< 20 / Abbe number; 0: all colours are refracted equally
};

/// glTF 2.0's metallic-roughness model with the extensions listed in docs/reference/gltf.md. Each map multiplies the factor
/// beside it, using the channels named here. Colour maps are sRGB textures; all other maps are linear.
struct MetallicRoughness {
  Vec4f base_color{1.0f};
  TextureMap base_color_map{};
  float metallic = 1.0f, roughness = 1.0f;
  TextureMap metallic_roughness_map{};  ///< channel G: roughness, channel B: metallic
  /// RGB = (n + 1) / 2 in tangent space. Texture coordinate v grows downwards, the bitangent upwards.
  TextureMap normal_map{};
  float normal_scale = 1.0f;        ///< multiplies x and y of the map's normal
  TextureMap occlusion_map{};       ///< channel R: share of the ambient light that arrives
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
  /// Like normal_map. None: the coat uses the surface normal without normal_map.
  TextureMap clearcoat_normal_map{};
  float clearcoat_normal_scale = 1.0f;
  float alpha_cutoff = 0.0f;  ///< mask mode: surfaces with an alpha below this are cut away; 0: no mask
  bool blend = false;         ///< blend mode: alpha is the coverage of the surface
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

/// Measured angular distribution of a lamp's light (IES LM-63): a grid of intensities over polar angles and azimuths,
/// interpolated linearly. Directions outside the grid get no light.
struct PhotometricWeb {
  std::string name{};
  std::vector<float> polar{};  ///< radians from the web's +z: at least two, increasing, within 0 to pi
  /// Radians from +x towards +y, increasing, within -pi to 2 pi. One value: the light is rotationally symmetric.
  std::vector<float> azimuth{};
  std::vector<float> intensity{};  ///< ordered by azimuth, then by polar angle; >= 0; relative: the mean over the sphere is 1
  Mat3f web_from_light{1.0f};      ///< a rotation, possibly mirrored; lights shine along -z
};

/// A light shines from its node's origin. Directional and spot lights shine along the node's -z.
struct Light {
  std::string name{};
  LightKind kind = LightKind::kPoint;
  int node = -1;
  /// Colour times intensity. It multiplies N.L (and albedo / pi for metallic-roughness surfaces).
  Vec3f color{1.0f};
  /// Point and spot lights: the light is divided by x + y d + z d^2 at distance d (Tachyon).
  Vec3f attenuation{1.0f, 0.0f, 0.0f};
  /// Point and spot lights: true: the light is divided by the squared distance (glTF); false: only by `attenuation` (Tachyon).
  bool inverse_square = false;
  float range = kInfinity;      ///< the light does not reach beyond this distance
  float inner_cone = 0.0f;      ///< spot lights: full strength within this half angle
  float outer_cone = kPi / 4;   ///< spot lights: no light beyond this half angle
  float visible_radius = 0.0f;  ///< > 0: rays see the light as a sphere of this radius and of its colour, which casts no shadow
  /// The size of the emitter, which softens shadows in path tracing; Whitted shading treats these lights as points. It changes
  /// neither the power of a lamp nor the light at points that see all of it. Camera rays do not see the emitter; mirrors do.
  float radius = 0.0f;            ///< point and spot lights: radius of the emitting sphere in world units; needs inverse_square
  float angular_diameter = 0.0f;  ///< directional lights: angular diameter of the emitting disc in radians, at most pi
  /// Spot lights fade between the cosines of the two cones. true: by 3 t^2 - 2 t^3 (Blender); false: by t^2.
  bool smooth_edge = false;
  /// Point lights: index into Scene::webs, whose value multiplies the colour. -1: the light is the same in all directions.
  int web = -1;
};

/// A panorama around the scene. transport/environment.hpp defines its orientation.
struct EnvironmentMap {
  static constexpr int kMostWidth = 32768, kMostHeight = 16384;
  Image radiance{};  ///< 3 channels, linear, finite and >= 0; equirectangular
  float strength = 1.0f;
  float rotation = 0.0f;  ///< rotation about +y in radians, from +x towards +z
};

/// Radiance of rays that hit nothing. If there is a map, it supplies the radiance. Otherwise the radiance is `horizon` where
/// dot(direction, up) <= horizon_at, `zenith` where it is >= zenith_at, and a linear blend in between.
struct Background {
  Vec3f horizon{0.0f};
  Vec3f zenith{0.0f};
  Vec3f up{0.0f, 1.0f, 0.0f};  ///< unit length
  /// Sines of the elevations at which the blend begins and ends, which must differ. If horizon_at > zenith_at, the blend is
  /// upside down.
  float horizon_at = 0.0f, zenith_at = 1.0f;
  std::optional<EnvironmentMap> map{};
};

/// A camera at its node's origin, which looks along the node's -z with +y up.
struct Camera {
  std::string name{};
  int node = -1;
  float vertical_fov = radians(45.0f);  ///< full vertical angle in radians
  float aspect = 1.0f;                  ///< width / height of the image that the file requests; 0: unknown
  float focus_distance = 0.0f;          ///< > 0: distance of the author's plane of interest, in node units
  Vec2f pixel_offset{0.0f};             ///< shifts the sample points of single views by this many pixels (x right, y down)
  float orthographic_height = 0.0f;     ///< > 0: orthographic, showing this height in node units; vertical_fov is ignored
  float near_distance = 0.0f;           ///< near clipping plane, node units in front of the camera
  Vec2f shift{0.0f};                    ///< moves the frame of a single view by this many of its heights, right and up
};

/// The author's placement of the lens array: the plane z = 0 of the node, +z towards the viewer, +y up.
struct DisplayPlacement {
  int node = -1;
  float plane_height = 1.0f;           ///< height of the array in node units
  float viewing_distance = kInfinity;  ///< distance from the array to the point that its cells converge to, in node units
};

// ---- Nodes and time -------------------------------------------------------------------------------------------------

/// Scales first, then rotates, then translates.
struct Transform {
  Vec3f translation{0.0f};
  Quatf rotation{1.0f, 0.0f, 0.0f, 0.0f};
  Vec3f scale{1.0f};
};

struct Node {
  std::string name{};
  int parent = -1;  ///< less than the node's own index: parents come first
  Transform local{};
  std::optional<Affine3f> matrix{};    ///< replaces `local` (nodes with a matrix in glTF); such a node cannot be animated
  std::vector<float> morph_weights{};  ///< default weights, one per morph target of the meshes shown here
};

/// A skeleton. A skinned mesh follows its joints and ignores the node of its instance. Vertex v moves to the sum over its
/// weights w_j of w_j (world_from_node[joints[j]] * joint_from_mesh[j]) v.
struct Skin {
  std::string name{};
  std::vector<int> joints{};                ///< indices of nodes
  std::vector<Affine3f> joint_from_mesh{};  ///< inverse bind matrix of each joint
};

enum class Interpolation { kStep, kLinear, kCubicSpline };

/// Keyframes of one animated quantity. The first value holds before the first key, the last one after the last key.
template <class T>
struct Channel {
  std::vector<double> times{};  ///< in seconds, strictly increasing; empty: the quantity is not animated
  std::vector<T> values{};      ///< one value per key; for kCubicSpline three: in-tangent, value, out-tangent
  Interpolation interpolation = Interpolation::kLinear;
};

struct NodeAnimation {
  int node = -1;
  Channel<Vec3f> translation{};
  Channel<Quatf> rotation{};  ///< with linear interpolation: spherical, along the shorter arc
  Channel<Vec3f> scale{};
  Channel<float> morph_weights{};  ///< each key has one value for each of the node's morph weights
};

/// Frame f shows the time f / frames_per_second.
struct Timeline {
  double frames_per_second = 25.0;
  int frame_count = 1;
  std::vector<NodeAnimation> animations{};  ///< at most one animation per node
  double time(int frame) const { return frame / frames_per_second; }
};

// ---- The scene ------------------------------------------------------------------------------------------------------

/// Shows a shape with a material at a node. Its index in Scene::instances is its object id.
struct Instance {
  std::string name{};
  int shape = -1, material = -1, node = -1;
  /// Index of a skin that moves the mesh; the mesh then needs SkinWeights, and the node does not move it.
  int skin = -1;
  /// Meshes only: camera rays pass through the instance, but mirrors show it and it emits light.
  bool hidden_from_cameras = false;
  bool casts_no_shadow = false;  ///< meshes; allowed for other shapes only if no instance of the scene casts shadows
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
  std::vector<Camera> cameras{};  ///< the first camera is the default
  /// Placement of the lens array; none: fitted to the first camera (stage/fit_array.hpp).
  std::optional<DisplayPlacement> display{};
  Background background{};
  Timeline timeline{};
  std::vector<std::string> animation_names{};  ///< names of all animations in the file
  int animation = -1;                          ///< index of the animation in `timeline`
  std::vector<std::string> variant_names{};    ///< names of the file's material variants
  /// Origin of the scene's coordinates, in file coordinates: a point p of the scene lies at origin + p in the file
  /// (scene/origin.hpp).
  Vec3d origin{0.0};
  Encoding encoding = Encoding::kSrgb;
  int max_depth = 6;       ///< longest path, in vertices; the file's own limit if it has one
  Vec2i resolution{0, 0};  ///< image size that the file requests; 0: none
  SceneKind kind = SceneKind::kPhysical;

  // Each of these functions appends one element and returns its index, by which other elements refer to it.
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
