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

/// Errors of frames before count less and less, as light changes, and not at all where it has changed for sure; but a few
/// patches know little.
class FrameErrors {
 public:
  /// The latest frame's, and what it may be. expected: of its pixels (GatherHistory); 0: not known.
  void add(const FrameError& now, const FrameError& may, float expected = 0.0f);

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
  FrameError found_, allowed_;  ///< weighted means
  FrameError latest_;
  PooledError pooled_, other_;
  float weight_ = 0.0f;
  Excess pixels_ = Excess::kNone, blocks_ = Excess::kNone;
};

}  // namespace lippmann
