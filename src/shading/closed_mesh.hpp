// Tests whether a mesh is closed. The inner sides of a closed mesh's triangles are invisible from outside.
#pragma once

namespace lippmann {

struct Mesh;

/// The side that the triangles of a closed mesh face.
enum class BodyFacing { kNone, kOutward, kInward };

/// Returns kNone unless the mesh is closed: each edge belongs to exactly two triangles, which traverse it in opposite
/// directions, and the volume is not 0. Vertices within a millionth of the mesh's size count as one, so seams of normals or
/// texture coordinates do not matter. Ignores degenerate triangles. Returns kNone if a point is not finite.
BodyFacing facing_of_closed(const Mesh& mesh);

}  // namespace lippmann
