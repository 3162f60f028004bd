// Makes one in-between frame from the point images of two others: projects points, averages colours and fills missed pixels.
//
// Based on the paper's interpolated animation. The treatment of missed pixels follows S. J. Adelson, L. F. Hodges, "Generating
// exact ray-traced animation frames by reprojection", IEEE Computer Graphics and Applications 15(3), 1995 (retrace).
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
  kPixel,     ///< pixels get the colour of the point that lands anywhere within them, as in the paper
  kEpipolar,  ///< changing colours are interpolated between samples (epipolar.hpp); only for arrays with whole pixels per lens
};

struct ForwardParams {
  SplatParams splat;
  SplatSampling sampling = SplatSampling::kEpipolar;
  MissedFill fill = MissedFill::kInterpolate;
  std::optional<FloorParams> floor;       ///< for make_to_floor()
  RayOrder order = RayOrder::kViewTiles;  ///< the order in which pixels are traced; only used with a floor
  bool wants_provenance = false;          ///< whether PointImage::provenance of made frames is filled
};

struct InBetweenCounts {
  std::uint64_t missed = 0;
  MissedCauses causes;
  std::uint64_t retraced = 0;
};

/// A frame's position between its two source frames.
struct SourcePair {
  const PointImage& previous;
  const PointImage& following;
  float position;  ///< share of the way from the previous to the following frame, 0 ... 1
};

/// Makes in-between frames and reuses memory from frame to frame. Use one object per animation; it is not thread-safe.
class InBetweenMaker {
 public:
  /// `scene` and `optics` must be those of the traced frames. With SplatMode::kLens, or optics that do not suit kEpipolar,
  /// colours are sampled by kPixel.
  InBetweenMaker(const Scene& scene, const Optics& optics, const ForwardParams& params);

  /// Completes a traced frame (film, points, moment), so that other frames can be made from it.
  void prepare(PointImage& frame, const ThreadPool& pool) const;

  /// Makes the film of the frame at frame.moment. If `as_source` is set, also fills the other data of a source frame.
  InBetweenCounts make(const SourcePair& between, bool as_source, const TracePixels& trace, const ThreadPool& pool,
                       PointImage& frame);

  /// Predicts the film of a traced frame, compares it with the traced film, and returns the evidence for other frames between
  /// the same two. `number` is the frame's number in its animation. The previous frame must have ray counts.
  FloorLesson learn_floor(const SourcePair& between, int number, const PointImage& traced, const ThreadPool& pool);

  /// Makes the film of the frame with a PSNR of at least params.floor, or finds that tracing the whole frame costs less; then
  /// the film is unusable.
  FloorOutcome make_to_floor(const SourcePair& between, int number, const Evidence& learned, const TracePackets& trace,
                             const ThreadPool& pool, PointImage& frame, InBetweenCounts& counts);

 private:
  Image& film_of(PointImage& frame) const;
  /// Sets the provenance of a frame. The colours of the pixels in missed_ have the provenance `missed`.
  void set_provenance(Provenance missed, PointImage& frame) const;
  /// Fills frame.film with the prediction, and uncertainty_.
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
  Image from_previous_, from_following_;  ///< predictions from one key frame alone
  std::vector<std::uint8_t> uncertainty_;
};

}  // namespace lippmann
