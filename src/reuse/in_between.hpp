// Makes an in-between frame from the point images of two other frames. Projects their points, averages the colours and fills
// missed pixels.
//
// Based on the interpolated animation of Eljdid, Aggoun and Youssef (README.md). Retracing missed pixels follows S. J. Adelson,
// L. F. Hodges, "Generating exact ray-traced animation frames by reprojection", IEEE Computer Graphics and Applications 15(3),
// 1995.
#pragma once

#include <optional>
#include <vector>

#include "reuse/epipolar.hpp"
#include "reuse/missed.hpp"
#include "reuse/quality_floor.hpp"
#include "reuse/retrace.hpp"
#include "reuse/uncertainty.hpp"

namespace lippmann {

enum class Provenance : std::uint8_t;

enum class SplatSampling {
  /// A pixel gets the colour of the point that lands anywhere in it, as in the paper.
  kPixel,
  /// Colours that change between samples are interpolated (epipolar.hpp). Needs a whole number of pixels per lens.
  kEpipolar,
};

struct ForwardParams {
  SplatParams splat;
  SplatSampling sampling = SplatSampling::kEpipolar;
  MissedFill fill = MissedFill::kInterpolate;
  std::optional<FloorParams> floor;       ///< only needed for make_to_floor()
  RayOrder order = RayOrder::kViewTiles;  ///< order of traced pixels; only used with a floor
  bool wants_provenance = false;
};

struct InBetweenCounts {
  std::uint64_t missed = 0;
  MissedCauses causes;
  std::uint64_t retraced = 0;
};

struct SourcePair {
  const PointImage& previous;
  const PointImage& following;
  float position;  ///< time between the sources: 0 is the previous frame, 1 the following frame
};

class InBetweenMaker {
 public:
  /// `scene` and `optics` must be those of the traced frames. Sampling falls back to kPixel if kEpipolar is not possible.
  InBetweenMaker(const Scene& scene, const Optics& optics, const ForwardParams& params);

  /// Prepares a traced frame, which has film, points and moment, for use as a source of other frames.
  void prepare(PointImage& frame, const ThreadPool& pool) const;

  /// Makes the film at the time frame.moment, and with `as_source` also points and contrast. Returns the counts of missed
  /// pixels.
  InBetweenCounts make(const SourcePair& between, bool as_source, const TracePixels& trace, const ThreadPool& pool,
                       PointImage& frame);

  /// Predicts a frame that was also traced. Returns the errors and costs of the prediction, which apply to other frames between
  /// the same two sources. The earlier source must have ray counts.
  FloorLesson learn_floor(const SourcePair& between, int number, const PointImage& traced, const ThreadPool& pool);

  /// Makes the film with a PSNR of at least params.floor. Returns `holds` = false, and an unusable film, if tracing the whole
  /// frame costs about the same or less.
  FloorOutcome make_to_floor(const SourcePair& between, int number, const Evidence& learned, const TracePackets& trace,
                             const ThreadPool& pool, PointImage& frame, InBetweenCounts& counts);

 private:
  Image& film_of(PointImage& frame) const;
  void set_provenance(Provenance missed, PointImage& frame) const;
  void predict(const SourcePair& between, const ThreadPool& pool, PointImage& frame, InBetweenCounts& counts);

  ForwardParams params_;
  Vec2i film_size_;
  Encoding encoding_;
  MotionGroups groups_;
  Splatter splatter_;
  ViewSteps steps_;
  std::optional<EpipolarSampler> sampler_;
  SplatBuffer landed_previous_, landed_following_;
  std::vector<std::uint32_t> missed_;
  std::optional<UncertaintyEstimator> uncertainty_estimator_;
  std::optional<Patches> patches_;
  Image from_previous_, from_following_;
  std::vector<std::uint8_t> uncertainty_;
};

}  // namespace lippmann
