// The interface of integrators. See docs/develop/add-an-integrator.md.
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

class FrameIntegrator {
 public:
  virtual ~FrameIntegrator() = default;

  /// Sets the sample number of the next camera rays.
  virtual void begin(int sample) = 0;
  /// Shades traced camera rays. May queue secondary rays until finish().
  virtual void primary(const CameraPacket& packet) = 0;
  virtual void finish() = 0;
  virtual const RayCounts& counts() const = 0;

  /// Records all later rays in `probe`, so that other frames can copy pixels. Only called if IntegratorFacts::can_share_pixels
  /// is set.
  virtual void set_probe(BlockProbe* probe);
};

/// Constructor arguments of an integrator. The referenced objects must outlive the integrator.
struct Integration {
  const ShadedScene& scene;
  const BeamFootprint& beam;
  const TraceParams& params;
  PathFilm film;  ///< integrators that do not separate direct and indirect light fill only `all` and `open`
};

/// Describes and creates an integrator. Each integrator defines one constant of this type.
struct IntegratorModel {
  IntegratorFacts facts;
  std::unique_ptr<FrameIntegrator> (*make)(const Integration& from);
};

extern const IntegratorModel whitted_model;
extern const IntegratorModel path_model;

}  // namespace lippmann
