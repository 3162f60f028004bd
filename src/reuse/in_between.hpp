// Makes one in-between frame from the point images of two others: projects, averages, deals with what is missed.
//
// The paper's interpolated animation; what to do with missed pixels after S. J. Adelson, L. F. Hodges, "Generating exact
// ray-traced animation frames by reprojection", IEEE Computer Graphics and Applications 15(3), 1995 (retrace).
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
  kPixel,     ///< the colour of the point that lands on a pixel, wherever on it it lands (the paper's)
  kEpipolar,  ///< where colours change, that between samples (epipolar.hpp); arrays with whole pixels per lens only
};

struct ForwardParams {
  SplatParams splat;
  SplatSampling sampling = SplatSampling::kEpipolar;
  MissedFill fill = MissedFill::kInterpolate;
  std::optional<FloorParams> floor;       ///< for make_to_floor()
  RayOrder order = RayOrder::kViewTiles;  ///< in which pixels are traced; with a floor only
  bool tells_provenance = false;          ///< made frames get PointImage::provenance
};

struct InBetweenCounts {
  std::uint64_t missed = 0;
  MissedCauses causes;
  std::uint64_t retraced = 0;
};

/// Where a frame lies between the two that it is made from.
struct SourcePair {
  const PointImage& previous;
  const PointImage& following;
  float position;  ///< the share of the way from the previous to the following one, 0 ... 1
};

/// Keeps its working memory from frame to frame: one per animation, used by one caller at a time.
class InBetweenMaker {
 public:
  /// `scene` and `optics` as traced. With kEpipolar and optics that do not suit it, or SplatMode::kLens, pixels are sampled.
  InBetweenMaker(const Scene& scene, const Optics& optics, const ForwardParams& params);

  /// Completes a frame that was traced (film, points, moment) so that others can be made from it.
  void prepare(PointImage& frame, const ThreadPool& pool) const;

  /// Makes the frame at frame.moment: its film and, where wanted, all that makes it a source in turn.
  InBetweenCounts make(const SourcePair& between, bool as_source, const TracePixels& trace, const ThreadPool& pool,
                       PointImage& frame);

  /// Predicts the film of a frame that is known, and tells what that teaches about others between the same two. `number` is the
  /// frame's in its animation; rays of the previous frame are counted.
  FloorLesson learn_floor(const SourcePair& between, int number, const PointImage& traced, const ThreadPool& pool);

  /// Makes the film of the frame so that its PSNR keeps to params.floor, or finds that it is better traced as a whole: then
  /// film is of no use.
  FloorOutcome make_to_floor(const SourcePair& between, int number, const Evidence& learned, const TracePackets& trace,
                             const ThreadPool& pool, PointImage& frame, InBetweenCounts& counts);

 private:
  Image& film_of(PointImage& frame) const;
  /// Of a frame of which missed_ were missed, which now come from `missed`.
  void tell_provenance(Provenance missed, PointImage& frame) const;
  /// Fills frame.film and uncertainty_.
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
  Image from_previous_, from_following_;  ///< predictions of one key frame alone
  std::vector<std::uint8_t> uncertainty_;
};

}  // namespace lippmann
