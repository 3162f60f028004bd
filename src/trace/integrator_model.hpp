// The interface of integrators. docs/develop/add-an-integrator.md lists the steps to add an integrator.
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

/// Adds the light of camera rays to their pixels. trace_batch() calls the functions. An object is not thread-safe, so each
/// thread has its own.
class FrameIntegrator {
 public:
  virtual ~FrameIntegrator() = default;

  /// Sets the sample number of the camera rays that follow.
  virtual void begin(int sample) = 0;
  /// Shades camera rays that have been traced. May queue secondary rays until finish().
  virtual void primary(const CameraPacket& packet) = 0;
  /// Traces all queued rays.
  virtual void finish() = 0;
  virtual const RayCounts& counts() const = 0;

  /// From now on, records all traced rays in `probe`, so that other frames can copy pixels. Only called if
  /// IntegratorFacts::can_share_pixels is true.
  virtual void set_probe(BlockProbe* probe);
};

/// The arguments of an integrator. The referenced objects must outlive the integrator.
struct Integration {
  const ShadedScene& scene;
  const BeamFootprint& beam;
  const TraceParams& params;
  PathFilm film;  ///< integrators that do not separate direct and indirect light fill only `all` and `open`
};

/// An integrator: its properties and its factory. Each integrator defines one constant of this type next to its class.
struct IntegratorModel {
  IntegratorFacts facts;
  std::unique_ptr<FrameIntegrator> (*make)(const Integration& from);
};

extern const IntegratorModel whitted_model;
extern const IntegratorModel path_model;

}  // namespace lippmann
