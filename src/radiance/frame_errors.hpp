// What the frames of a history have measured of their errors, and whether that is too much.
#pragma once

#include "radiance/gather_error.hpp"

namespace lippmann {

/// Whether an error is larger than it may be.
enum class Excess { kNone, kProbable, kSure };

/// What a frame's error is, as far as it and earlier ones tell. Frames have in common by how much errors differ from what is
/// expected of them, even where errors change from frame to frame.
class PooledError {
 public:
  /// The latest frame's, and what was expected of it; 0: not known.
  void add(const PixelError& now, float expected);
  const PixelError& of_latest() const { return of_latest_; }

 private:
  void go_on(float log_ratio, float variance);

  float log_ratio_ = 0.0f, variance_ = 0.0f;  ///< of errors over what was expected
  float drift_ = 0.0f;                        ///< variance of its changes from frame to frame
  float weight_ = 0.0f;                       ///< of what drift_ is told by; 0: no frame yet
  PixelError of_latest_;
};

/// What errors of means are, over what they may be. A frame's few patches tell it with a deviation of 0.7 to 3 times what is
/// allowed; how much errors change from frame to frame is small beside that.
class PooledMeans {
 public:
  /// What the next frame is expected to have, instead of what frames before have told.
  void expect(float ratio, float deviation);
  /// What a frame was measured to have.
  void add(float ratio, float deviation);
  void forget() { knows_ = false; }
  float ratio() const { return ratio_; }
  float deviation() const;

 private:
  float ratio_ = 0.0f, variance_ = 0.0f;
  bool knows_ = false;                    ///< else these two mean nothing
  float noise_ = 0.0f, measured_ = 0.0f;  ///< the mean variance of what frames were measured to have, and their number
};

/// Errors of frames before count less and less, as light changes, and not at all where it has changed for sure; but a few
/// patches know little.
class FrameErrors {
 public:
  /// The latest frame's, and what it may be. expected: of its pixels (GatherHistory); 0: not known.
  void add(const FrameError& now, const FrameError& may, float expected = 0.0f);

  /// What means of the next frame are expected to err by, instead of what frames before have told of them.
  void expect_means(const PixelError& blocks, float may);

  const FrameError& found() const { return found_; }

  /// The squared error of the latest frame's pixels, as far as this and earlier frames tell, and FrameError::other.
  const PixelError& of_latest() const { return pooled_.of_latest(); }
  const PixelError& other_of_latest() const { return other_.of_latest(); }
  const FrameError& allowed() const { return allowed_; }

  const FrameError& latest() const { return latest_; }

  /// Whether the latest frame errs by too much.
  Excess pixels() const { return pixels_; }
  Excess blocks() const { return blocks_; }
  bool is_good() const { return pixels_ == Excess::kNone && blocks_ == Excess::kNone; }
  bool is_too_large() const { return pixels_ == Excess::kSure || blocks_ == Excess::kSure; }

 private:
  FrameError found_, allowed_;  ///< weighted means; of blocks, as means_ has it
  PooledMeans means_;
  FrameError latest_;
  PooledError pooled_, other_;
  float weight_ = 0.0f;
  Excess pixels_ = Excess::kNone, blocks_ = Excess::kNone;
};

}  // namespace lippmann
