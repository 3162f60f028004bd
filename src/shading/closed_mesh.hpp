// Tests whether a mesh is closed, so that the inner sides of its triangles are invisible from outside.
#pragma once

namespace lippmann {

struct Mesh;

/// The side that the triangles of a closed mesh face. kNone: the mesh is not closed.
enum class BodyFacing { kNone, kOutward, kInward };

/// Returns the facing of a closed mesh, otherwise kNone. In a closed mesh, each edge belongs to exactly two triangles, which
/// traverse it in opposite directions, and the volume is not 0. Vertices within a millionth of the mesh's size count as one.
/// Degenerate triangles are ignored. Returns kNone if a position is not finite.
BodyFacing facing_of_closed(const Mesh& mesh);

}  // namespace lippmann
