// Updates deforming meshes for a frame: vertices, gradients of texture coordinates, and Embree's copy of the vertices.
#pragma once

#include "device/embree_shim.hpp"
#include "device/scene_geometry.hpp"
#include "lippmann/core/parallel.hpp"
#include "scene/deform.hpp"

namespace lippmann {

/// Returns one gradient per triangle. `uvs` is one of the mesh's sets of texture coordinates. It must not be empty.
std::vector<UvGradient> make_uv_gradients(const Mesh& mesh, const std::vector<Vec2f>& uvs);

void pose_vertices(const MeshPose& pose, PosedMesh& posed, const ThreadPool& pool);

/// Updates Embree's copy of the vertices. The caller must commit the scene afterwards.
void store_vertices(const Mesh& mesh, const EmbreeGeometry& geometry);

}  // namespace lippmann
