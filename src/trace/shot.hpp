// The scene, optics and workers of a render.
#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/optics.hpp"
#include "trace/device_scene.hpp"
#include "trace/film_rows.hpp"

namespace lippmann {

/// A scene at one time, seen through optics placed in it.
struct Shot {
  const DeviceScene& device;  ///< in the state of its last update()
  const Optics& optics;
  Affine3f world_from_display{};  ///< maps mm to world units; a similarity
  FilmRows rows{};                ///< rows to render; films, layers and pixel indices cover these rows only
};

/// Returns the size of the rendered image.
inline Vec2i film_size(const Shot& shot) { return film_size(shot.optics, shot.rows); }

enum class Progress { kSilent, kReported };

/// The threads, the cancellation context, and whether the work counts as progress of the frame.
struct Workers {
  const ThreadPool& pool;
  const Context& context;
  Progress progress = Progress::kReported;
  /// Returns the same workers without progress reports. Cancellation still applies.
  Workers silent() const { return {pool, context, Progress::kSilent}; }
};

}  // namespace lippmann
