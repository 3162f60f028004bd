#pragma once

#include <cstdint>
#include <optional>

#include "lippmann/optics/optics.hpp"
#include "optics/model.hpp"

namespace lippmann {

enum class StepDirection { kLeft, kRight, kUp, kDown };
inline constexpr StepDirection kStepDirections[] = {StepDirection::kLeft, StepDirection::kRight, StepDirection::kUp,
                                                    StepDirection::kDown};

/// Iterates in one direction over the pixels of a view, or over the pixels below a lens.
class ViewWalk {
 public:
  std::optional<std::uint32_t> next() {
    place_ += step_;
    if (!(place_.x >= low_.x && place_.x < high_.x && place_.y >= low_.y && place_.y < high_.y)) return std::nullopt;
    const auto x = static_cast<std::uint32_t>(place_.x), y = static_cast<std::uint32_t>(place_.y);
    return y * width_ + x;
  }

 private:
  friend class ViewSteps;
  Vec2f place_, step_, low_, high_;
  std::uint32_t width_;
};

/// Finds the neighbours of a pixel.
/// - kView: the pixels at (or nearest to) the same offset below the neighbouring lenses. Along cylindrical lenses, the
///   neighbours are pixels of the next row.
/// - kLens: the neighbouring pixels below the same lens. For hexagonal packing, the area below a lens is approximated by a
///   rectangle of lens pitch by row pitch.
/// In single views and quilts, kView and kLens both mean the neighbouring pixels of the same view.
class ViewSteps {
 public:
  ViewSteps(const Optics& optics, StepsWithin within);

  ViewWalk walk(std::uint32_t pixel, StepDirection direction) const;

  float length_px(StepDirection direction) const { return glm::length(step_of(direction)); }

 private:
  Vec2f step_of(StepDirection direction) const;
  void limit_to_tile(Vec2f place, ViewWalk& walk) const;
  void limit_to_lens(Vec2f place, ViewWalk& walk) const;

  Vec2i film_;
  StepRule rule_;
};

}  // namespace lippmann
