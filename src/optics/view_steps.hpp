// From a pixel to its neighbours in the same picture: in the same directional view, or below the same lens.
#pragma once

#include <cstdint>
#include <optional>

#include "lippmann/optics/optics.hpp"
#include "optics/model.hpp"

namespace lippmann {

enum class StepDirection { kLeft, kRight, kUp, kDown };
inline constexpr StepDirection kStepDirections[] = {StepDirection::kLeft, StepDirection::kRight, StepDirection::kUp,
                                                    StepDirection::kDown};

/// The pixels of one picture in one direction, one after the other.
class ViewWalk {
 public:
  /// The next pixel; none where the view, the lens or the panel ends.
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

/// Same view (kView): the pixels at the same offset below the next lenses, or as near to it as pixels are; along the
/// lenses of a lenticular sheet or a slanted panel the next row. Same lens (kLens): the next pixels, as long as they lie below
/// the same lens (of hexagons: in the rectangle of lens pitch by row pitch). In single views and in the views of a quilt: the
/// next pixels of that view.
class ViewSteps {
 public:
  /// `optics` must pass validate().
  ViewSteps(const Optics& optics, StepsWithin within);

  ViewWalk walk(std::uint32_t pixel, StepDirection direction) const;

  /// How far a step in that direction is, pixels.
  float length_px(StepDirection direction) const { return glm::length(step_of(direction)); }

 private:
  Vec2f step_of(StepDirection direction) const;
  void limit_to_tile(Vec2f place, ViewWalk& walk) const;
  void limit_to_lens(Vec2f place, ViewWalk& walk) const;

  Vec2i film_;
  StepRule rule_;
};

}  // namespace lippmann
