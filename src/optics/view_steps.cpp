#include "optics/view_steps.hpp"

#include <cmath>

#include "optics/models.hpp"

namespace lippmann {

ViewSteps::ViewSteps(const Optics& optics, StepsWithin within)
    : film_(film_size(optics)),
      rule_(std::visit([&](const auto& model) { return step_rule(optics.panel, model, within); }, optics.model)) {}

Vec2f ViewSteps::step_of(StepDirection direction) const {
  switch (direction) {
    case StepDirection::kLeft:
      return -rule_.across;
    case StepDirection::kRight:
      return rule_.across;
    case StepDirection::kUp:
      return -rule_.down;
    case StepDirection::kDown:
      break;
  }
  return rule_.down;
}

void ViewSteps::limit_to_tile(Vec2f place, ViewWalk& walk) const {
  const Vec2i at(place.x, std::max(0.0f, place.y - static_cast<float>(rule_.padding_top)));
  const Vec2i tile = glm::min(at / rule_.tile, rule_.last_tile),
              first(tile.x * rule_.tile.x, rule_.padding_top + tile.y * rule_.tile.y);
  walk.low_ = {first.x, tile.y == 0 ? 0 : first.y};
  walk.high_ = {tile.x == rule_.last_tile.x ? film_.x : first.x + rule_.tile.x, first.y + rule_.tile.y};
}

void ViewSteps::limit_to_lens(Vec2f place, ViewWalk& walk) const {
  const auto limit = [](const LensAxis<float>& axis, float s, float shift, float scale, float& low, float& high) {
    const float begin = axis.start_px + std::floor((s - axis.start_px) * axis.cells_per_px) * axis.cell_px;
    low = std::max(low, std::ceil((begin + shift) * scale - 0.5f));
    high = std::min(high, std::ceil((begin + axis.cell_px + shift) * scale - 0.5f));
  };
  if (rule_.bounds == StepRule::Bounds::kSheetLens) {
    const float shift = place.y * rule_.sine;
    limit(rule_.columns, place.x * rule_.cosine - shift, shift, rule_.inverse_cosine, walk.low_.x, walk.high_.x);
  } else if (rule_.bounds == StepRule::Bounds::kSquareLens) {
    limit(rule_.columns, place.x, 0.0f, 1.0f, walk.low_.x, walk.high_.x);
    limit(rule_.rows, place.y, 0.0f, 1.0f, walk.low_.y, walk.high_.y);
  } else {
    const HexagonalCell<float> cell = hexagon_at(rule_.columns, rule_.rows, place.x, place.y);
    const Vec2f size(rule_.columns.cell_px, rule_.rows.cell_px);
    const Vec2f centre = place - Vec2f(cell.from_column, cell.from_row) * size;
    walk.low_ = glm::max(walk.low_, glm::ceil(centre - 0.5f * size - 0.5f));
    walk.high_ = glm::min(walk.high_, glm::ceil(centre + 0.5f * size - 0.5f));
  }
}

ViewWalk ViewSteps::walk(std::uint32_t pixel, StepDirection direction) const {
  ViewWalk walk;
  walk.width_ = static_cast<std::uint32_t>(film_.x);
  walk.place_ = {static_cast<float>(pixel % walk.width_) + 0.5f, static_cast<float>(pixel / walk.width_) + 0.5f};
  walk.step_ = step_of(direction);
  walk.low_ = Vec2f(0.0f), walk.high_ = Vec2f(film_);
  const bool along_slanted = walk.step_.x != 0.0f && walk.step_.y != 0.0f;
  if (rule_.bounds == StepRule::Bounds::kTile)
    limit_to_tile(walk.place_, walk);
  else if (rule_.bounds != StepRule::Bounds::kPanel && !along_slanted)
    limit_to_lens(walk.place_, walk);
  return walk;
}

}  // namespace lippmann
