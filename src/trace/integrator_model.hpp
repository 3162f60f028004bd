// The interface of integrators of whole frames. docs/develop/add-an-integrator.md lists the steps to add one.
#pragma once

#include <memory>

#include "device/touch_probe.hpp"
#include "lippmann/trace/integrator.hpp"
#include "lippmann/trace/ray_counts.hpp"
#include "shading/surface.hpp"
#include "trace/camera_packet.hpp"
#include "trace/path_film.hpp"

namespace lippmann {

struct ShadedScene;
struct TraceParams;

/// Adds the light that camera rays bring to their pixels. An object serves one thread at a time; trace_batch() calls it.
class FrameIntegrator {
 public:
  virtual ~FrameIntegrator() = default;

  /// Sets the sample number within each pixel for the camera rays that follow.
  virtual void begin(int sample) = 0;
  /// Shades camera rays that have met the scene. Rays that follow from them may wait for finish().
  virtual void primary(const CameraPacket& packet) = 0;
  /// Traces everything that waits.
  virtual void finish() = 0;
  virtual const RayCounts& counts() const = 0;

  /// From now on `probe` hears of every ray, so that other frames can copy pixels. Only called where the facts say
  /// can_share_pixels.
  virtual void tell(BlockProbe* probe);
};

/// What integrators of frames are made of. All of it outlives them.
struct Integration {
  const ShadedScene& scene;
  const BeamFootprint& beam;
  const TraceParams& params;
  PathFilm film;  ///< integrators that do not separate light fill only `all` and `open`
};

/// An integrator: a constant beside its class.
struct IntegratorModel {
  IntegratorFacts facts;
  std::unique_ptr<FrameIntegrator> (*make)(const Integration& from);
};

extern const IntegratorModel whitted_model;
extern const IntegratorModel path_model;

}  // namespace lippmann
