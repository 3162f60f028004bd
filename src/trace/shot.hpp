#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/optics.hpp"
#include "trace/device_scene.hpp"
#include "trace/film_rows.hpp"

namespace lippmann {

/// A scene at one time, seen through optics.
struct Shot {
  const DeviceScene& device;
  const Optics& optics;
  Affine3f world_from_display{};  ///< maps mm of the display frame to world units; a similarity
  FilmRows rows{};                ///< rows to render; films, layers and pixel indices cover only these rows
};

inline Vec2i film_size(const Shot& shot) { return film_size(shot.optics, shot.rows); }

enum class Progress { kSilent, kReported };

/// The threads that perform a task, and the context that can cancel the task. `progress` states whether to report the progress
/// of the task as progress of the frame.
struct Workers {
  const ThreadPool& pool;
  const Context& context;
  Progress progress = Progress::kReported;
  Workers silent() const { return {pool, context, Progress::kSilent}; }
};

}  // namespace lippmann
