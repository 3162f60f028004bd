// What is rendered of one moment, and by whom.
#pragma once

#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/optics/optics.hpp"
#include "trace/device_scene.hpp"
#include "trace/film_rows.hpp"

namespace lippmann {

/// A scene as it is at the moment, seen through optics that lie somewhere in it.
struct Shot {
  const DeviceScene& device;  ///< where update() has moved it
  const Optics& optics;
  Affine3f world_from_display{};  ///< mm to the world's units: a similarity
  FilmRows rows{};                ///< that are rendered: films, layers and pixels' numbers are those of these rows alone
};

/// The size of what is rendered.
inline Vec2i film_size(const Shot& shot) { return film_size(shot.optics, shot.rows); }

enum class Progress { kSilent, kTold };

/// Who works, who may say stop, and whether that work is progress of the frame.
struct Workers {
  const ThreadPool& pool;
  const Context& context;
  Progress progress = Progress::kTold;
  /// For what is done besides the frame. It is stopped just as well.
  Workers silent() const { return {pool, context, Progress::kSilent}; }
};

}  // namespace lippmann
