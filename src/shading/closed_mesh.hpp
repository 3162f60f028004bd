// Tests whether a mesh is closed. From outside a closed mesh, the inner sides of its triangles are invisible.
#pragma once

namespace lippmann {

struct Mesh;

/// The side that the triangles of a closed mesh face. kNone: the mesh is not closed.
enum class BodyFacing { kNone, kOutward, kInward };

/// Returns the facing of a closed mesh, otherwise kNone. A mesh is closed if each edge belongs to exactly two triangles, which
/// traverse the edge in opposite directions, and if the volume is not 0. Vertices within a millionth of the mesh's size count
/// as one, so that seams of normals or texture coordinates do not matter. Degenerate triangles are ignored. Returns kNone if a
/// position is not finite.
BodyFacing facing_of_closed(const Mesh& mesh);

}  // namespace lippmann
