// Path tracing in full: at every vertex one light is sampled by a shadow ray (next-event estimation), and the path goes on in
// a direction drawn from the BSDF, until roulette or its depth ends it.
#pragma once

#include <array>

#include "trace/path_tracer.hpp"
#include "trace/shadow_queue.hpp"

namespace lippmann {

class PathIntegrator : public PathTracer<PathIntegrator> {
 public:
  /// The scene was made for Integrator::kPath; film.all is not null.
  PathIntegrator(const ShadedScene& scene, const BeamFootprint& beam, const PathParams& params, const PathFilm& film);

  /// From now on camera rays are sample number `sample` of their pixels.
  void begin(int sample);

  /// Where light is gathered.
  struct DiffuseVertex {
    const ShadingPoint& point;
    const BsdfPacket& bsdfs;
    int lane;      ///< of bsdfs
    float length;  ///< from the start of the path that led there
    /// Takes the surface back to where it was in the frame before; null: it lies still, or nobody watches.
    const Affine3f* before = nullptr;
  };
  /// Begins to gather what a diffuse surface receives but for lights of groups before `from` (not kPoint): of other lights by
  /// aiming at one that was drawn for its point and normal, of all else by a path, in a direction by `way` in [0, 1). Adds
  /// throughput x what a white surface there would send on to ray.pixel of the film. `ray` led to the point.
  void gather_diffuse(const DiffuseVertex& at, const PathRay& ray, LightGroup from, const std::optional<LightSample>& light,
                      Vec2f way);
  /// The first half of that: aims at the light.
  void aim_at(const DiffuseVertex& at, const PathRay& ray, const LightSample& light);
  /// And the path of the other half, for who traces it by other means: none where it would begin behind the surface. Its
  /// density is the direction's alone.
  std::optional<PathRay> bounce(const DiffuseVertex& at, const PathRay& ray, LightGroup from, Vec2f way);

  /// What has to do with what moves, by pixel of the film: see RadianceRecord.
  struct PossibleChange {
    float light = 0.0f, share = 0.0f;
    /// The same of a surface that moves by itself: by how much more light falls onto it as it stands now than as it stood, were
    /// the way free.
    float turned_light = 0.0f, turned_share = 0.0f;
  };
  /// From now on every ray that gather_diffuse() leads to is tested against the probe's boxes; `changes`, one for each pixel of
  /// the film, receives what those that meet one stand for. Both outlive this.
  void watch(const TouchProbe& probe, std::vector<PossibleChange>& changes) { probe_ = &probe, changes_ = &changes; }

 private:
  friend class PathTracer<PathIntegrator>;
  static constexpr bool kSeesLight = true, kWidensBeams = true;

  LaneMask begin_packet(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays);
  void scatter(const RayHitPacket& packet, const PathRay* rays);
  void end_packet(const RayHitPacket&, const PathRay*) {}
  float chance(LightGroups, const LightReceiver&) const { return 1.0f; }
  float chance_of_round(std::size_t, const LightReceiver&) const { return 1.0f; }
  void end_path(const PathRay& ray, Vec3f radiance) { add(ray.pixel, clamped(radiance, ray.surfaces()), ray.surfaces()); }
  void trace_shadow_rays();

  void watch_packet(const RayHitPacket& packet, const LaneMask& active, const PathRay* rays);
  void watch_turning(const DiffuseVertex& at, const LightSample& light, const PathRay& ray);
  std::optional<LightSample> light_for(int i, const PathRay& ray);
  void shine(int i, const LightSample& light, const BsdfValue& value, const PathRay& ray);
  Vec3f from_wide_light(int i, const LightSample& light, const BsdfValue& value) const;
  void go_on(int i, const PathRay& ray, const BsdfSample& sample);
  Vec3f clamped(Vec3f radiance, int depth) const;

  const TouchProbe* probe_ = nullptr;  ///< null: nothing is watched
  std::vector<PossibleChange>* changes_ = nullptr;
  std::array<float, 2> noise_weights_{};  ///< what a sample of the first and of the second half counts: see weights_of_halves()
  Lanes near_share_;                      ///< of the vertices whose light has been asked for (LightReceiver::near_share)
  ShadowQueue shadow_rays_;
};

}  // namespace lippmann
