// Whether a mesh encloses a body, so that the insides of its triangles are hidden from all that is outside.
#pragma once

namespace lippmann {

struct Mesh;

/// Which way the triangles of a closed mesh face.
enum class BodyFacing { kNone, kOutward, kInward };

/// kNone unless every edge of the mesh is that of two triangles, which go along it in opposite directions, and the body has a
/// volume. Vertices that lie within a millionth of the mesh's size count as one, as where normals or texture coordinates have a
/// seam. Triangles without two different edges count for nothing. A point that is not finite: kNone.
BodyFacing facing_of_closed(const Mesh& mesh);

}  // namespace lippmann
