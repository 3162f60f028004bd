// A scene as its file describes it: shapes, materials, lights, cameras, a node hierarchy and its animation. Plain data.
//
// Rules that hold for everything here. Elements refer to each other by index into the Scene's vectors; -1 means none. World
// space is right-handed; lengths are the file's own units. Colours are linear and scene-referred unless the scene's
// `encoding` says otherwise. Texture row 0 is the top row; texture coordinate v grows downwards (as in glTF); textures repeat
// or clamp as their wrap says. A shape's coordinates are local to the node of the instance that shows it.
// A Scene is description: the structures that rays are traced against are built from it by trace/device_scene.hpp, and
// where things are at a given time is asked of scene/timeline.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

// ---- Shapes ---------------------------------------------------------------------------------------------------------

/// What is added to a mesh, per vertex, times the weight that Node::morph_weights or its animation gives; each may be empty.
struct MorphTarget {
  std::vector<Vec3f> positions, normals, tangents;
};

/// Which joints of the instance's Skin carry each vertex, and how much: vertex v has the entries from v * per_vertex on.
struct SkinWeights {
  int per_vertex = 0;                 ///< 0: the mesh cannot be skinned
  std::vector<std::uint32_t> joints;  ///< indices into Skin::joints
  std::vector<float> weights;         ///< >= 0, those of a vertex sum to 1
};

struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;                           ///< per vertex, unit length; empty: faceted
  std::vector<Vec2f> uvs;                               ///< per vertex; empty: no texture coordinates
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertex indices, each < positions.size(); counter-clockwise = front
  std::vector<Vec3f> colors{};                          ///< per vertex; multiply the material's color; empty: white
  std::vector<float> alphas{};                          ///< per vertex; multiply the material's alpha; empty: 1
  std::vector<Vec2f> uvs_1{};                           ///< the second set of texture coordinates; empty: none
  std::vector<Vec4f> tangents{};       ///< per vertex: unit t and w = +-1, bitangent w (normal x t); empty: from the uvs
  std::vector<MorphTarget> targets{};  ///< before the skin
  SkinWeights skin{};
};

/// Set 0 or 1 of a mesh's texture coordinates.
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

/// 3D Gaussians that shine in their own colours: a captured scene, as training on photographs leaves it. Seen along a ray,
/// splat i covers opacities[i] * exp(-d^2 / 2) of what lies behind the point where d, the distance from its centre in standard
/// deviations, is least. All vectors but `harmonics` have one element for each splat.
struct Splats {
  std::vector<Vec3f> centers;
  std::vector<Quatf> rotations;   ///< unit length: from the axes of the deviations to those of the shape
  std::vector<Vec3f> deviations;  ///< standard deviations along its three axes, > 0
  std::vector<float> opacities;   ///< 0 to 1
  int degree = 0;                 ///< of the spherical harmonics, 0 to 3
  /// (degree + 1)^2 for each splat, by l and then by m from -l to l. A colour is 0.5 + sum of harmonics * basis function at the
  /// ray's direction, in the shape's axes, at least 0. The basis is the real one with the Condon-Shortley phase.
  std::vector<Vec3f> harmonics;
  bool is_linear = false;  ///< colours are linear light; false: sRGB-encoded, and splats cover one another so
};

using Spheres = std::vector<Sphere>;
using Cylinders = std::vector<Cylinder>;
using Planes = std::vector<Plane>;
using Rings = std::vector<Ring>;
using Boxes = std::vector<Box>;

/// Analytic shapes are exact, never tessellated; the node above them must not scale them unevenly. Splats have no use for a
/// material; theirs is unlit.
using Shape = std::variant<Mesh, Spheres, Cylinders, Planes, Rings, Boxes, Splats>;

// ---- Materials ------------------------------------------------------------------------------------------------------

enum class Wrap { kRepeat, kMirror, kClamp };

struct Texture {
  std::string name;
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 bytes a texel, rows top to bottom
  bool srgb = true;                ///< R, G, B are sRGB-encoded; false: the byte / 255 is the value
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
};

enum class ProjectionKind {
  kPlane,     ///< u and v along u_axis and v_axis (Tachyon's TEXFUNC 9)
  kCylinder,  ///< u around v_axis, v along it (TEXFUNC 7)
  kSphere,    ///< u around v_axis, v from -v_axis (0) to v_axis (1) (TEXFUNC 8)
};

/// Projects a texture onto whatever it meets, after Tachyon's image maps (formulas: trace/projection.hpp).
struct ImageProjection {
  ProjectionKind kind = ProjectionKind::kPlane;
  Vec3f center{0.0f}, rotate{0.0f}, scale{1.0f};
  Vec3f u_axis{1.0f, 0.0f, 0.0f}, v_axis{0.0f, 1.0f, 0.0f};  ///< kCylinder and kSphere: orthonormal
};

enum class Highlight {
  kNone,
  kPlastic,  ///< in the light's colour
  kMetal,    ///< in the surface's colour
};

/// Whitted's surface as Tachyon computes it:
/// color (ambient + diffuse sum L N.L) + highlight sum (N.H)^highlight_size + mirror reflected + (1 - opacity) transmitted +
/// emission.
struct PhongSurface {
  Vec3f color{0.8f};
  int texture = -1;                           ///< replaces (projected) or multiplies (uv) color
  std::optional<ImageProjection> projection;  ///< how the texture is mapped; without it by the mesh's uvs
  float ambient = 0.1f, diffuse = 0.9f;
  Highlight highlight_kind = Highlight::kNone;
  float highlight = 0.0f, highlight_size = 1.0f;
  float mirror = 0.0f;   ///< share of the mirror direction's radiance
  float opacity = 1.0f;  ///< 1 - opacity of the radiance behind comes through
  float ior = 1.0f;      ///< refracts what comes through; 1 = straight on
  Vec3f emission{0.0f};
};

/// A texture, and how a surface looks it up: at offset + matrix * uv of one of the mesh's sets (glTF's KHR_texture_transform).
struct TextureMap {
  int texture = -1;        ///< -1: none, which reads as white
  int uv_set = 0;          ///< 0: Mesh::uvs, 1: Mesh::uvs_1
  glm::mat2 matrix{1.0f};  ///< columns
  Vec2f offset{0.0f};
};

/// Fibres that scatter light at grazing angles, above everything but the clear coat (KHR_materials_sheen).
struct Sheen {
  Vec3f color{0.0f};  ///< black: there is none
  TextureMap color_map;
  float roughness = 0.0f;
  TextureMap roughness_map;  ///< A
};

/// Gloss that is rougher along one direction of the surface (KHR_materials_anisotropy).
struct Anisotropy {
  float strength = 0.0f;  ///< 0 to 1: how much rougher along the direction than across
  float rotation = 0.0f;  ///< angle by which the direction is turned from the tangent towards the bitangent
  TextureMap map;         ///< RG = (direction + 1) / 2 before the rotation, B: strength
};

/// A film on the surface, as thin as light waves are long (KHR_materials_iridescence).
struct Iridescence {
  float share = 0.0f;  ///< how much of the surface has the film, 0 to 1
  TextureMap map;      ///< R
  float ior = 1.3f;
  float least_thickness_nm = 100.0f, most_thickness_nm = 400.0f;
  TextureMap thickness_map;  ///< G: from least to most; none: most
};

/// Light that enters on one side and leaves on the other in all directions (KHR_materials_diffuse_transmission).
struct DiffuseTransmission {
  float share = 0.0f;  ///< how much of the diffuse light passes through, 0 to 1
  TextureMap map;      ///< A
  Vec3f color{1.0f};
  TextureMap color_map;
};

/// What lies behind a surface that lets light through (KHR_materials_volume).
struct Volume {
  bool is_solid = false;                   ///< a closed shape, filled; false: both sides of a thin wall, which bends nothing
  Vec3f attenuation_color{1.0f};           ///< what is left of white light after the attenuation distance
  float attenuation_distance = kInfinity;  ///< in world units
};

/// Extensions of glTF's that few materials have.
struct SurfaceExtensions {
  Sheen sheen;
  Anisotropy anisotropy;
  Iridescence iridescence;
  DiffuseTransmission diffuse_transmission;
  std::optional<Volume> volume;  ///< none: what transmits light refracts it, as closed shapes do, and absorbs nothing
  float dispersion = 0.0f;       ///< 20 / Abbe number; 0: all colours are refracted alike
};

/// glTF 2.0's metallic-roughness model with the extensions that docs/reference/gltf.md lists. Maps multiply the factors beside
/// them, with the channels named here; colours are sRGB textures, all else is stored as it is.
struct MetallicRoughness {
  Vec4f base_color{1.0f};
  TextureMap base_color_map;
  float metallic = 1.0f, roughness = 1.0f;
  TextureMap metallic_roughness_map;  ///< G: roughness, B: metallic
  TextureMap normal_map;              ///< RGB = (n + 1) / 2 in tangent space; v grows downwards, the bitangent upwards
  float normal_scale = 1.0f;          ///< multiplies x and y of the map's normal
  TextureMap occlusion_map;           ///< R: share of the surroundings' light that arrives
  float occlusion_strength = 1.0f;    ///< 1 + strength * (R - 1)
  Vec3f emissive{0.0f};
  TextureMap emissive_map;
  float ior = 1.5f;
  float transmission = 0.0f;
  TextureMap transmission_map;  ///< R
  float specular = 1.0f;        ///< strength of the dielectric reflection
  TextureMap specular_map;      ///< A
  Vec3f specular_color{1.0f};   ///< colour of the dielectric reflection at normal incidence; may exceed 1
  TextureMap specular_color_map;
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
  TextureMap clearcoat_map;            ///< R
  TextureMap clearcoat_roughness_map;  ///< G
  TextureMap clearcoat_normal_map;     ///< as normal_map; none: the coat follows the surface without its normal map
  float clearcoat_normal_scale = 1.0f;
  float alpha_cutoff = 0.0f;  ///< alpha below this is cut away (mask mode); 0: no mask
  bool blend = false;         ///< alpha is coverage (blend mode)
  bool double_sided = false;
  bool unlit = false;
  std::optional<SurfaceExtensions> extensions{};
};

struct Material {
  std::string name;
  std::variant<PhongSurface, MetallicRoughness> surface;
};

// ---- Lights, background, camera, display ----------------------------------------------------------------------------

enum class LightKind { kPoint, kDirectional, kSpot };

/// How light of a lamp spreads over directions, as it was measured (IES LM-63): intensities where polar angles and azimuths
/// cross, linear in between, none beyond.
struct PhotometricWeb {
  std::string name;
  std::vector<float> polar;      ///< radians from the web's +z: at least two, increasing, from 0 to pi
  std::vector<float> azimuth;    ///< radians from its +x towards its +y, increasing, from -pi to 2 pi; one: alike all around
  std::vector<float> intensity;  ///< by azimuth, then by polar angle, >= 0; relative: the mean over the sphere is 1
  Mat3f web_from_light{1.0f};    ///< a rotation, or one and a mirror; lights shine along -z
};

/// A light shines from its node's origin; directional and spot lights along the node's -z.
struct Light {
  std::string name;
  LightKind kind = LightKind::kPoint;
  int node = -1;
  Vec3f color{1.0f};  ///< times intensity: what multiplies N.L (and albedo / pi for metallic-roughness surfaces)
  Vec3f attenuation{1.0f, 0.0f, 0.0f};  ///< point and spot: divide by x + y d + z d^2 at distance d (Tachyon)
  bool inverse_square = false;          ///< point and spot: divide by the squared distance (glTF); else constant (Tachyon)
  float range = kInfinity;              ///< no light beyond this distance
  float inner_cone = 0.0f;              ///< spot: full strength within this half angle
  float outer_cone = kPi / 4;           ///< spot: none beyond this half angle
  float visible_radius = 0.0f;          ///< > 0: rays see the light as a sphere of its colour (it casts no shadow)
  /// Sizes, which soften the shadows of traced paths; Whitted's shading takes these lights for points. They change neither the
  /// power of a lamp nor what it sends to a point in sight of all of it. The eye does not see the lamp, mirrors do.
  float radius = 0.0f;            ///< point and spot: the sphere that shines has this radius, world units; needs inverse_square
  float angular_diameter = 0.0f;  ///< directional: the disc in the sky that shines is so wide, at most pi
  bool smooth_edge = false;       ///< spot: fades by 3 t^2 - 2 t^3 between the cosines of its cones (Blender), not by t^2
  int web = -1;                   ///< point: Scene::webs, by which the colour is multiplied in every direction; -1: all alike
};

/// A panorama around the scene; how it lies: transport/environment.hpp.
struct EnvironmentMap {
  static constexpr int kMostWidth = 32768, kMostHeight = 16384;
  Image radiance;         ///< 3 channels, linear, finite and >= 0; equirectangular
  float strength = 1.0f;  ///< factor
  float rotation = 0.0f;  ///< radians about +y, from +x towards +z
};

/// What a ray sees that hits nothing: the map where there is one, else `horizon` where dot(direction, up) <= horizon_at,
/// `zenith` where it is >= zenith_at, in between a linear blend.
struct Background {
  Vec3f horizon{0.0f};
  Vec3f zenith{0.0f};
  Vec3f up{0.0f, 1.0f, 0.0f};                 ///< unit length
  float horizon_at = 0.0f, zenith_at = 1.0f;  ///< sines of elevation, not equal; exchanged, the blend is turned over
  std::optional<EnvironmentMap> map{};
};

/// Looks along its node's -z with +y up.
struct Camera {
  std::string name;
  int node = -1;
  float vertical_fov = radians(45.0f);  ///< full angle
  float aspect = 1.0f;                  ///< width / height that the file asks for; 0: unknown
  float focus_distance = 0.0f;          ///< > 0: where the author put the plane of interest, in node units
  Vec2f pixel_offset{0.0f};             ///< single views shift their sample points by this many pixels (x right, y down)
  float orthographic_height = 0.0f;     ///< > 0: shows this height, in node units, at every distance; then without an angle
};

/// Where the author put the lens array: the plane z = 0 of the node, +z towards the viewer, +y up.
struct DisplayPlacement {
  int node = -1;
  float plane_height = 1.0f;           ///< height of the array in node units
  float viewing_distance = kInfinity;  ///< node units in front of the array that the array's cells converge to
};

// ---- Nodes and time -------------------------------------------------------------------------------------------------

/// Scales, then rotates, then moves.
struct Transform {
  Vec3f translation{0.0f};
  Quatf rotation{1.0f, 0.0f, 0.0f, 0.0f};
  Vec3f scale{1.0f};
};

struct Node {
  std::string name;
  int parent = -1;  ///< < own index: parents come first
  Transform local;
  std::optional<Affine3f> matrix;      ///< replaces `local` (glTF matrix nodes); such a node is not animated
  std::vector<float> morph_weights{};  ///< one for each morph target of the meshes shown here, where not animated
};

/// A skeleton. A skinned mesh stands where its joints are, whatever node shows it: a vertex v of it is at
/// sum over its weights w_j (world_from_node[joints[j]] * joint_from_mesh[j]) v.
struct Skin {
  std::string name;
  std::vector<int> joints;                ///< nodes
  std::vector<Affine3f> joint_from_mesh;  ///< per joint: where the mesh stood when it was bound (inverse bind matrix)
};

enum class Interpolation { kStep, kLinear, kCubicSpline };

/// Values of one animated quantity. Before the first key and after the last, the end value holds.
template <class T>
struct Channel {
  std::vector<double> times;  ///< seconds, strictly increasing; empty: not animated
  std::vector<T> values;      ///< one per key; for kCubicSpline three: in-tangent, value, out-tangent
  Interpolation interpolation = Interpolation::kLinear;
};

struct NodeAnimation {
  int node = -1;
  Channel<Vec3f> translation;
  Channel<Quatf> rotation;  ///< linear = spherical along the shorter arc
  Channel<Vec3f> scale;
  Channel<float> morph_weights{};  ///< in place of each value as many as the node has morph weights
};

/// Frame f shows the time f / frames_per_second.
struct Timeline {
  double frames_per_second = 25.0;
  int frame_count = 1;
  std::vector<NodeAnimation> animations;  ///< at most one per node
  double time(int frame) const { return frame / frames_per_second; }
};

// ---- The scene ------------------------------------------------------------------------------------------------------

/// Shows a shape, made of a material, where a node is. Its index in Scene::instances is its object id.
struct Instance {
  std::string name;
  int shape = -1, material = -1, node = -1;
  int skin = -1;                     ///< moves the mesh instead of the node; the mesh has SkinWeights
  bool hidden_from_cameras = false;  ///< meshes: no camera ray meets it, though mirrors show it and it shines
  bool casts_no_shadow = false;      ///< meshes; other shapes only if no instance of the scene casts a shadow
};

/// The model that a scene's materials and lights follow. It decides the default sampling: see completed() in
/// frames/frame_params.hpp.
enum class SceneKind {
  kPhysical,  ///< physical materials and light: files of glTF, OBJ and PLY, and scenes made in memory
  kWhitted,   ///< Whitted shading: the built-in scenes, and files of NFF and Tachyon
  kSplats,    ///< splats alone, whose colours hold their light already
};

struct Scene {
  std::string name;
  std::vector<Node> nodes;
  std::vector<Shape> shapes;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Instance> instances;
  std::vector<Skin> skins;
  std::vector<Light> lights;
  std::vector<PhotometricWeb> webs{};
  std::vector<Camera> cameras;              ///< the first is the default one
  std::optional<DisplayPlacement> display;  ///< none: fitted to the first camera (stage/fit_array.hpp)
  Background background;
  Timeline timeline;
  std::vector<std::string> animation_names;  ///< all animations that the file has
  int animation = -1;                        ///< which of them the timeline shows
  std::vector<std::string> variant_names{};  ///< the file's sets of materials to choose from
  Vec3d origin{0.0};  ///< of the scene's coordinates, in the file's: what lies at p is at origin + p there (scene/origin.hpp)
  Encoding encoding = Encoding::kSrgb;
  int max_depth = 6;       ///< path vertices; the file's own limit where it has one
  Vec2i resolution{0, 0};  ///< that the file asks for; 0: none
  SceneKind kind = SceneKind::kPhysical;
};

}  // namespace lippmann
