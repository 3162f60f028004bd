// The interface of integrators. docs/develop/add-an-integrator.md lists the steps to add one.
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

/// Adds the light of camera rays to their pixels. Not thread-safe: each thread has its own object. trace_batch() calls it.
class FrameIntegrator {
 public:
  virtual ~FrameIntegrator() = default;

  /// Sets the sample number within each pixel for the camera rays that follow.
  virtual void begin(int sample) = 0;
  /// Shades camera rays that have been traced. Secondary rays may be queued until finish().
  virtual void primary(const CameraPacket& packet) = 0;
  /// Traces all queued rays.
  virtual void finish() = 0;
  virtual const RayCounts& counts() const = 0;

  /// Records all following rays in `probe`, so that other frames can copy pixels. Only called if the facts set
  /// can_share_pixels.
  virtual void set_probe(BlockProbe* probe);
};

/// The arguments of an integrator. All references must outlive the integrator.
struct Integration {
  const ShadedScene& scene;
  const BeamFootprint& beam;
  const TraceParams& params;
  PathFilm film;  ///< integrators that do not separate light fill only `all` and `open`
};

/// An integrator: its properties and its factory. Each integrator defines one constant of this type next to its class.
struct IntegratorModel {
  IntegratorFacts facts;
  std::unique_ptr<FrameIntegrator> (*make)(const Integration& from);
};

extern const IntegratorModel whitted_model;
extern const IntegratorModel path_model;

}  // namespace lippmann
