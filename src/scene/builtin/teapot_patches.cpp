// The control points are from: Martin Newell, "The Utilization of Procedure Models in Digital Image Synthesis", PhD thesis,
// University of Utah, 1975. The bottom was added by Frank Crow ("The Origins of the Teapot", IEEE CG&A 7(1), 1987).
//
// Rim, body, lid and bottom consist of four equal quarters; the table lists one of them. Handle and spout are symmetric about
// the plane y = 0; the table lists the side y <= 0.
#include "scene/builtin/teapot_patches.hpp"

namespace lippmann::builtin {
namespace {

/// One row of a quarter's control points, all at height z. In (x, y) they are (radius, 0), (radius, -corner), (corner, -radius)
/// and (0, -radius).
struct QuarterRow {
  float radius, corner, z;
};
using QuarterPatch = std::array<QuarterRow, 4>;

constexpr QuarterPatch kQuarters[] = {
    {{{1.4f, 0.784f, 2.4f}, {1.3375f, 0.749f, 2.53125f}, {1.4375f, 0.805f, 2.53125f}, {1.5f, 0.84f, 2.4f}}},
    {{{1.5f, 0.84f, 2.4f}, {1.75f, 0.98f, 1.875f}, {2.0f, 1.12f, 1.35f}, {2.0f, 1.12f, 0.9f}}},
    {{{2.0f, 1.12f, 0.9f}, {2.0f, 1.12f, 0.45f}, {1.5f, 0.84f, 0.225f}, {1.5f, 0.84f, 0.15f}}},
    {{{0.0f, 0.0f, 3.15f}, {0.8f, 0.45f, 3.15f}, {0.0f, 0.0f, 2.85f}, {0.2f, 0.112f, 2.7f}}},
    {{{0.2f, 0.112f, 2.7f}, {0.4f, 0.224f, 2.55f}, {1.3f, 0.728f, 2.55f}, {1.3f, 0.728f, 2.4f}}},
    {{{1.5f, 0.84f, 0.15f}, {1.5f, 0.84f, 0.075f}, {1.425f, 0.798f, 0.0f}, {0.0f, 0.0f, 0.0f}}},
};

constexpr float kSides[4][4][4][3] = {
    {{{-1.6f, 0, 2.025f}, {-1.6f, -0.3f, 2.025f}, {-1.5f, -0.3f, 2.25f}, {-1.5f, 0, 2.25f}},
     {{-2.3f, 0, 2.025f}, {-2.3f, -0.3f, 2.025f}, {-2.5f, -0.3f, 2.25f}, {-2.5f, 0, 2.25f}},
     {{-2.7f, 0, 2.025f}, {-2.7f, -0.3f, 2.025f}, {-3.0f, -0.3f, 2.25f}, {-3.0f, 0, 2.25f}},
     {{-2.7f, 0, 1.8f}, {-2.7f, -0.3f, 1.8f}, {-3.0f, -0.3f, 1.8f}, {-3.0f, 0, 1.8f}}},
    {{{-2.7f, 0, 1.8f}, {-2.7f, -0.3f, 1.8f}, {-3.0f, -0.3f, 1.8f}, {-3.0f, 0, 1.8f}},
     {{-2.7f, 0, 1.575f}, {-2.7f, -0.3f, 1.575f}, {-3.0f, -0.3f, 1.35f}, {-3.0f, 0, 1.35f}},
     {{-2.5f, 0, 1.125f}, {-2.5f, -0.3f, 1.125f}, {-2.65f, -0.3f, 0.9375f}, {-2.65f, 0, 0.9375f}},
     {{-2.0f, 0, 0.9f}, {-2.0f, -0.3f, 0.9f}, {-1.9f, -0.3f, 0.6f}, {-1.9f, 0, 0.6f}}},
    {{{1.7f, 0, 1.425f}, {1.7f, -0.66f, 1.425f}, {1.7f, -0.66f, 0.6f}, {1.7f, 0, 0.6f}},
     {{2.6f, 0, 1.425f}, {2.6f, -0.66f, 1.425f}, {3.1f, -0.66f, 0.825f}, {3.1f, 0, 0.825f}},
     {{2.3f, 0, 2.1f}, {2.3f, -0.25f, 2.1f}, {2.4f, -0.25f, 2.025f}, {2.4f, 0, 2.025f}},
     {{2.7f, 0, 2.4f}, {2.7f, -0.25f, 2.4f}, {3.3f, -0.25f, 2.4f}, {3.3f, 0, 2.4f}}},
    {{{2.7f, 0, 2.4f}, {2.7f, -0.25f, 2.4f}, {3.3f, -0.25f, 2.4f}, {3.3f, 0, 2.4f}},
     {{2.8f, 0, 2.475f}, {2.8f, -0.25f, 2.475f}, {3.525f, -0.25f, 2.49375f}, {3.525f, 0, 2.49375f}},
     {{2.9f, 0, 2.475f}, {2.9f, -0.15f, 2.475f}, {3.45f, -0.15f, 2.5125f}, {3.45f, 0, 2.5125f}},
     {{2.8f, 0, 2.4f}, {2.8f, -0.15f, 2.4f}, {3.2f, -0.15f, 2.4f}, {3.2f, 0, 2.4f}}},
};

Vec3f turned_quarter(Vec3f p, int quarters) {
  for (int i = 0; i < quarters; ++i) p = {-p.y, p.x, p.z};
  return p;
}

BezierPatch quarter_patch(const QuarterPatch& rows, int quarters) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    const auto& [r, c, z] = rows[row];
    const Vec3f points[4] = {{r, 0, z}, {r, -c, z}, {c, -r, z}, {0, -r, z}};
    for (std::size_t column = 0; column < 4; ++column) patch[row][column] = turned_quarter(points[column], quarters);
  }
  return patch;
}

BezierPatch side_patch(const float (&points)[4][4][3], bool mirrored) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      const float* p = points[row][mirrored ? 3 - column : column];
      patch[row][column] = {p[0], mirrored ? -p[1] : p[1], p[2]};
    }
  return patch;
}

}  // namespace

std::vector<BezierPatch> teapot_patches() {
  std::vector<BezierPatch> patches;
  for (const QuarterPatch& rows : kQuarters)
    for (int quarters = 0; quarters < 4; ++quarters) patches.push_back(quarter_patch(rows, quarters));
  for (const auto& points : kSides)
    for (const bool mirrored : {false, true}) patches.push_back(side_patch(points, mirrored));
  return patches;
}

}  // namespace lippmann::builtin
