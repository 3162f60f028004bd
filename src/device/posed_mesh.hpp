#pragma once

#include "device/embree_shim.hpp"
#include "device/scene_geometry.hpp"
#include "lippmann/core/parallel.hpp"
#include "scene/deform.hpp"

namespace lippmann {

/// Returns one gradient per triangle. `uvs` is one of the mesh's sets of texture coordinates.
std::vector<UvGradient> make_uv_gradients(const Mesh& mesh, const std::vector<Vec2f>& uvs);

void pose_vertices(const MeshPose& pose, PosedMesh& posed, const ThreadPool& pool);

/// Copies the mesh's vertices into the geometry. The caller must commit the scene afterwards.
void store_vertices(const Mesh& mesh, const EmbreeGeometry& geometry);

}  // namespace lippmann
