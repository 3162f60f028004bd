// Writes a mesh that changes its shape as it is at the moment: vertices, texture gradients, Embree's copy.
#pragma once

#include "device/embree_shim.hpp"
#include "device/scene_geometry.hpp"
#include "lippmann/core/parallel.hpp"
#include "scene/deform.hpp"

namespace lippmann {

/// Per triangle. uvs: one of the mesh's sets, not empty.
std::vector<UvGradient> make_uv_gradients(const Mesh& mesh, const std::vector<Vec2f>& uvs);

/// Brings the mesh's vertices and gradients to the pose.
void pose_vertices(const MeshPose& pose, PosedMesh& posed, const ThreadPool& pool);

/// Brings Embree's copy of the vertices up to date; the scene that it is in is still to be committed.
void store_vertices(const Mesh& mesh, const EmbreeGeometry& geometry);

}  // namespace lippmann
