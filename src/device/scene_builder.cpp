#include <algorithm>
#include <map>

#include "device/builder_tasks.hpp"
#include "device/embree_scene.hpp"
#include "device/posed_mesh.hpp"
#include "device/shadow_filter.hpp"
#include "device/splat_geometry.hpp"
#include "device/user_geometry.hpp"
#include "scene/deform.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kFlattenTriangles = 200'000;

/// Rays can reach at least this multiple of the scene's size. An instance that would require a lower limit is hidden.
constexpr float kLeastReach = 1000.0f;

/// Uses Embree's robust triangle test. The faster test rounds the common edge of two triangles differently for each, so that
/// one in ten rays along the edge would pass between them.
EmbreeScene make_scene(RTCDevice device, RTCSceneFlags flags) {
  EmbreeScene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), flags | RTC_SCENE_FLAG_ROBUST);
  return scene;
}

/// Returns a multiple of the inverse transpose that keeps normals on the outer side. It also works for singular m.
Mat3f outward_normals(const Mat3f& m) {
  const Mat3f cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0.0f ? -cofactors : cofactors;
}

Vec3f normalized_or(Vec3f v, Vec3f otherwise) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : otherwise;
}

bool is_singular(const Mat3f& m) {
  const float volume = std::abs(glm::determinant(m));
  return !(volume > 1e-12f * glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]));
}

/// Returns the largest r such that points with world coordinates from -r to r have mesh coordinates below kLargestReach.
float reach_of(const Affine3f& mesh_from_world) {
  const Mat3f& m = mesh_from_world.linear;
  const Vec3f sums = glm::abs(m[0]) + glm::abs(m[1]) + glm::abs(m[2]), moved = glm::abs(mesh_from_world.translation);
  const float factor = std::max({1.0f, sums.x, sums.y, sums.z}), offset = std::max({moved.x, moved.y, moved.z});
  return std::max(0.0f, (kLargestReach - offset) / factor);  // std::max turns NaN into 0
}

class SceneBuilder {
 public:
  SceneBuilder(const BuiltScene& built, const ResolvedScene& resolved, const ShadowMaterials& materials, const ThreadPool& pool)
      : geometry_(built.geometry),
        embree_(built.embree),
        materials_(materials),
        scene_(*geometry_.scene),
        at_(resolved),
        pool_(pool) {}

  void build() {
    RTCDevice device = embree_.device.get();
    embree_.fixed = make_scene(device, RTC_SCENE_FLAG_NONE);
    embree_.moving = make_scene(device, RTC_SCENE_FLAG_DYNAMIC);
    count_mesh_uses();
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) add_instance(static_cast<std::uint32_t>(i));
    attach_tables(geometry_.fixed_tables, embree_.fixed_primitives, embree_.fixed.get(), embree_.has_fixed);
    attach_tables(geometry_.moving_tables, embree_.moving_primitives, embree_.moving.get(), embree_.has_moving);
    commit_scene(embree_.fixed);
    commit_scene(embree_.moving);
    check_embree(device, "building the scene", embree_.memory);
  }

 private:
  void count_mesh_uses() {
    for (const Instance& instance : scene_.instances) ++uses_[instance.shape];
  }

  void add_instance(std::uint32_t index) {
    const Instance& instance = scene_.instances[index];
    const Shape& shape = scene_.shapes[static_cast<std::size_t>(instance.shape)];
    const float transmittance = materials_.transmittance(index);
    const bool moving = geometry_.instance_moves[index];
    PrimitiveTables& tables = moving ? geometry_.moving_tables : geometry_.fixed_tables;
    const Affine3f place = at_.of(instance.node);
    if (const auto* mesh = std::get_if<Mesh>(&shape)) {
      if (mesh->triangles.empty()) return;
      if (is_posed(scene_, instance))
        add_posed(*mesh, index, moving);
      else
        add_mesh(*mesh, instance, index, moving, place);
    } else if (const auto* planes = std::get_if<Planes>(&shape)) {
      for (const Plane& plane : *planes) geometry_.planes.push_back({to_world(place, plane), index, transmittance});
    } else if (const auto* spheres = std::get_if<Spheres>(&shape)) {
      add_primitives(tables.spheres, *spheres, place, index, transmittance);
    } else if (const auto* cylinders = std::get_if<Cylinders>(&shape)) {
      add_primitives(tables.cylinders, *cylinders, place, index, transmittance);
    } else if (const auto* rings = std::get_if<Rings>(&shape)) {
      add_primitives(tables.rings, *rings, place, index, transmittance);
    } else if (const auto* boxes = std::get_if<Boxes>(&shape)) {
      add_primitives(tables.boxes, *boxes, place, index, transmittance);
    } else if (const auto* splats = std::get_if<Splats>(&shape)) {
      geometry_.splats.sets.push_back({index, splats, Mat3f(1.0f)});
    }
  }

  template <class Primitive, class Source>
  static void add_primitives(PrimitiveTable<Primitive>& table, const std::vector<Source>& sources, const Affine3f& place,
                             std::uint32_t instance, float transmittance) {
    for (const Source& source : sources) {
      table.primitives.push_back(to_world(place, source));
      table.instance.push_back(instance);
      table.transmittance.push_back(transmittance);
    }
    table.see_through |= transmittance > 0.0f;
  }

  void add_mesh(const Mesh& mesh, const Instance& instance, std::uint32_t index, bool moving, const Affine3f& place) {
    const std::size_t copies = mesh.triangles.size() * static_cast<std::size_t>(uses_.at(instance.shape));
    if (!moving && (uses_.at(instance.shape) == 1 || copies <= kFlattenTriangles))
      add_flattened(mesh, index, place);
    else
      add_placed(mesh, instance, index, moving, place);
  }

  void add_flattened(const Mesh& mesh, std::uint32_t index, const Affine3f& place) {
    auto world = std::make_unique<Mesh>(mesh);
    for (Vec3f& p : world->positions) p = transform_point(place, p);
    const Mat3f normal_matrix = outward_normals(place.linear);
    for (Vec3f& n : world->normals) n = normalized_or(normal_matrix * n, n);
    const float turned = glm::determinant(place.linear) < 0.0f ? -1.0f : 1.0f;  // mirroring reverses the bitangent
    for (Vec4f& t : world->tangents) t = Vec4f(normalized_or(place.linear * Vec3f(t), Vec3f(t)), turned * t.w);
    if (glm::determinant(place.linear) < 0.0f)  // mirrored meshes get the opposite winding, so that it agrees with the normals
      for (auto& triangle : world->triangles) std::swap(triangle[1], triangle[2]);
    const EmbreeGeometry geometry = make_triangles(*world, index);
    set_rays_met(geometry.get(), index);
    const auto id = static_cast<unsigned>(geometry_.records.size());
    rtcAttachGeometryByID(embree_.fixed.get(), geometry.get(), id);
    embree_.has_fixed = true;
    GeometryRecord record;
    record.instance = index;
    record.mesh = world.get();
    record.uv_gradients = {uv_gradients(*world, 0), uv_gradients(*world, 1)};
    geometry_.flattened.push_back(std::move(world));
    push_record(record, {});
  }

  void add_placed(const Mesh& mesh, const Instance& instance, std::uint32_t index, bool moving, const Affine3f& place) {
    // There is one scene per mesh and material, because the shadow filter of a transparent material belongs to the geometry.
    EmbreeScene& mesh_scene = embree_.mesh_scenes[{instance.shape, instance.material}];
    if (!mesh_scene) {
      mesh_scene = make_scene(embree_.device.get(), RTC_SCENE_FLAG_NONE);
      rtcAttachGeometryByID(mesh_scene.get(), make_triangles(mesh, index).get(), 0);
      commit_scene(mesh_scene);
    }
    EmbreeGeometry geometry(rtcNewGeometry(embree_.device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
    rtcSetGeometryInstancedScene(geometry.get(), mesh_scene.get());
    set_rays_met(geometry.get(), index);
    GeometryRecord record;
    record.placed = true;
    record.instance = index;
    record.mesh = &mesh;
    record.uv_gradients = {uv_gradients(mesh, 0), uv_gradients(mesh, 1)};
    place_record(record, geometry.get(), place);
    const auto id = static_cast<unsigned>(geometry_.records.size());
    rtcAttachGeometryByID((moving ? embree_.moving : embree_.fixed).get(), geometry.get(), id);
    (moving ? embree_.has_moving : embree_.has_fixed) = true;
    if (moving) embree_.moving_records.push_back(static_cast<int>(id));
    push_record(record, std::move(geometry));
  }

  const std::vector<UvGradient>* uv_gradients(const Mesh& mesh, int set) {
    const std::vector<Vec2f>& uvs = uvs_of(mesh, set);
    if (uvs.empty()) return nullptr;
    auto [entry, is_new] = geometry_.uv_gradients.try_emplace({&mesh, set});
    if (is_new) entry->second = make_uv_gradients(mesh, uvs);
    return &entry->second;
  }

  EmbreeGeometry make_triangles(const Mesh& mesh, std::uint32_t instance) {
    EmbreeGeometry geometry(rtcNewGeometry(embree_.device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    void* vertices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f),
                                             mesh.positions.size());
    void* indices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), mesh.triangles.size());
    if (!vertices || !indices) check_embree(embree_.device.get(), "storing a mesh", embree_.memory);
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3f*>(vertices));
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), static_cast<std::array<std::uint32_t, 3>*>(indices));
    if (std::unique_ptr<ShadowCaster> caster = materials_.caster(instance)) {
      filter_shadows(geometry.get(), *caster);
      embree_.shadow_casters.push_back(std::move(caster));
    }
    rtcSetGeometryMask(geometry.get(), ~0u);  // Embree 4 sets only one bit by default
    rtcCommitGeometry(geometry.get());
    return geometry;
  }

  void set_rays_met(RTCGeometry geometry, std::uint32_t index) const {
    const Instance& instance = scene_.instances[index];
    const unsigned hidden_from =
        (instance.hidden_from_cameras ? kCameraRay : 0u) | (instance.casts_no_shadow ? kShadowRay : 0u);
    rtcSetGeometryMask(geometry, ~hidden_from);
    rtcCommitGeometry(geometry);
  }

  void add_posed(const Mesh& mesh, std::uint32_t index, bool moving) {
    const MeshPose pose(scene_, scene_.instances[index], at_);
    auto posed = std::make_unique<PosedMesh>();
    posed->mesh = mesh;
    posed->mesh.targets.clear();
    posed->mesh.skin = {};
    posed->mirrored = pose.mirrors();
    if (posed->mirrored)
      for (auto& triangle : posed->mesh.triangles) std::swap(triangle[1], triangle[2]);
    pose_vertices(pose, *posed, pool_);
    EmbreeGeometry geometry = make_triangles(posed->mesh, index);
    set_rays_met(geometry.get(), index);
    posed->record = static_cast<std::uint32_t>(geometry_.records.size());
    if (moving) {
      rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_REFIT);
      rtcCommitGeometry(geometry.get());
    }
    rtcAttachGeometryByID((moving ? embree_.moving : embree_.fixed).get(), geometry.get(), posed->record);
    (moving ? embree_.has_moving : embree_.has_fixed) = true;
    GeometryRecord record;
    record.instance = index;
    record.mesh = &posed->mesh;
    for (int set = 0; set < 2; ++set)
      if (!uvs_of(mesh, set).empty())
        record.uv_gradients[static_cast<std::size_t>(set)] = &posed->uv_gradients[static_cast<std::size_t>(set)];
    push_record(record, {});
    geometry_.posed.push_back(std::move(posed));
    embree_.posed.push_back(std::move(geometry));
  }

  void place_record(GeometryRecord& record, RTCGeometry geometry, const Affine3f& place) const;

  void push_record(const GeometryRecord& record, EmbreeGeometry geometry) {
    geometry_.records.push_back(record);
    embree_.placed.push_back(std::move(geometry));
  }

  template <class Primitive>
  void attach_table(PrimitiveTable<Primitive>& table, EmbreeGeometry& geometry, GeometryKind kind, RTCScene scene, bool& used) {
    if (table.primitives.empty()) return;
    used = true;
    geometry = make_user_geometry(embree_.device.get(), table);
    rtcAttachGeometryByID(scene, geometry.get(), static_cast<unsigned>(geometry_.records.size()));
    GeometryRecord record;
    record.kind = kind;
    record.primitives = &table;
    record.instance_of_primitive = &table.instance;
    record.one_material = std::all_of(table.instance.begin(), table.instance.end(), [&](std::uint32_t instance) {
      return scene_.instances[instance].material == scene_.instances[table.instance.front()].material;
    });
    push_record(record, {});
  }

  void attach_tables(PrimitiveTables& tables, PrimitiveGeometries& geometries, RTCScene scene, bool& used) {
    attach_table(tables.spheres, geometries.spheres, GeometryKind::kSpheres, scene, used);
    attach_table(tables.cylinders, geometries.cylinders, GeometryKind::kCylinders, scene, used);
    attach_table(tables.rings, geometries.rings, GeometryKind::kRings, scene, used);
    attach_table(tables.boxes, geometries.boxes, GeometryKind::kBoxes, scene, used);
  }

  SceneGeometry& geometry_;
  RayScene::Embree& embree_;
  const ShadowMaterials& materials_;
  const Scene& scene_;
  const ResolvedScene& at_;
  const ThreadPool& pool_;
  std::map<int, int> uses_;
};

/// Hides the instance if its transform is singular, or if rays within least_reach could exceed kLargestReach in mesh space.
void place(GeometryRecord& record, RTCGeometry geometry, const Affine3f& world_from_mesh, float least_reach) {
  record.reach = reach_of(inverse(world_from_mesh));
  if (is_singular(world_from_mesh.linear) || !(record.reach >= least_reach)) {  // animations hide objects by scaling them to 0
    record.reach = kLargestReach;
    record.hidden = true;
    rtcDisableGeometry(geometry);
    rtcCommitGeometry(geometry);
    return;
  }
  record.hidden = false;
  record.world_from_mesh = world_from_mesh;
  record.normal_from_mesh = glm::transpose(glm::inverse(world_from_mesh.linear));
  rtcEnableGeometry(geometry);
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &world_from_mesh);
  rtcCommitGeometry(geometry);
}
static_assert(sizeof(Affine3f) == 12 * sizeof(float), "handed to Embree as 3 x 4 floats, column by column");

void SceneBuilder::place_record(GeometryRecord& record, RTCGeometry geometry, const Affine3f& world_from_mesh) const {
  place(record, geometry, world_from_mesh, kLeastReach * geometry_.size);
}

float least_reach_of(const std::vector<GeometryRecord>& records) {
  float reach = kLargestReach;
  for (const GeometryRecord& record : records) reach = std::min(reach, record.reach);
  return reach;
}

template <class Source, class Primitive>
void move_primitives(PrimitiveTable<Primitive>& table, const EmbreeGeometry& geometry, const Scene& scene,
                     const ResolvedScene& resolved) {
  if (table.primitives.empty()) return;
  std::size_t next = 0;
  while (next < table.primitives.size()) {
    const Instance& instance = scene.instances[table.instance[next]];
    const Affine3f place = resolved.of(instance.node);
    for (const Source& source : std::get<std::vector<Source>>(scene.shapes[static_cast<std::size_t>(instance.shape)]))
      table.primitives[next++] = to_world(place, source);
  }
  update_user_geometry(geometry);
}

void move_planes(SceneGeometry& geometry, const ResolvedScene& resolved) {
  std::size_t next = 0;
  while (next < geometry.planes.size()) {
    const Instance& instance = geometry.scene->instances[geometry.planes[next].instance];
    const Affine3f place = resolved.of(instance.node);
    for (const Plane& plane : std::get<Planes>(geometry.scene->shapes[static_cast<std::size_t>(instance.shape)]))
      geometry.planes[next++].plane = to_world(place, plane);
  }
}

void move_tables(PrimitiveTables& tables, const PrimitiveGeometries& geometries, const Scene& scene,
                 const ResolvedScene& resolved) {
  move_primitives<Sphere>(tables.spheres, geometries.spheres, scene, resolved);
  move_primitives<Cylinder>(tables.cylinders, geometries.cylinders, scene, resolved);
  move_primitives<Ring>(tables.rings, geometries.rings, scene, resolved);
  move_primitives<Box>(tables.boxes, geometries.boxes, scene, resolved);
}

}  // namespace

void build_scene(const BuiltScene& built, const ResolvedScene& resolved, const ShadowMaterials& materials,
                 const ThreadPool& pool) {
  pool.run([&] {
    SceneBuilder(built, resolved, materials, pool).build();
    place_splats(built, resolved);
  });
  built.geometry.reach = least_reach_of(built.geometry.records);
}

void move_scene(const BuiltScene& built, const ResolvedScene& resolved, const ThreadPool& pool) {
  SceneGeometry& geometry = built.geometry;
  RayScene::Embree& embree = built.embree;
  move_planes(geometry, resolved);
  const auto moves = [&](const SplatSet& set) { return geometry.instance_moves[set.instance]; };
  if (std::any_of(geometry.splats.sets.begin(), geometry.splats.sets.end(), moves))
    pool.run([&] { place_splats(built, resolved); });
  if (!embree.has_moving) return;
  for (const int id : embree.moving_records) {
    GeometryRecord& record = geometry.records[static_cast<std::size_t>(id)];
    place(record, embree.placed[static_cast<std::size_t>(id)].get(),
          resolved.of(geometry.scene->instances[record.instance].node), kLeastReach * geometry.size);
  }
  geometry.reach = least_reach_of(geometry.records);
  for (std::size_t p = 0; p < geometry.posed.size(); ++p) {
    PosedMesh& posed = *geometry.posed[p];
    const std::uint32_t instance = geometry.records[posed.record].instance;
    if (!geometry.instance_moves[instance]) continue;
    pose_vertices(MeshPose(*geometry.scene, geometry.scene->instances[instance], resolved), posed, pool);
    store_vertices(posed.mesh, embree.posed[p]);
  }
  move_tables(geometry.moving_tables, embree.moving_primitives, *geometry.scene, resolved);
  pool.run([&] { commit_scene(embree.moving); });
  check_embree(embree.device.get(), "moving the scene", embree.memory);
}

}  // namespace lippmann
