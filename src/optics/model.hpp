// The interface of optics models. The header of a model, such as lenticular.hpp, overloads the functions below. models.hpp
// lists all models. The public functions (lippmann/optics/*.hpp) use only this interface.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/view_cameras.hpp"
#include "lippmann/optics/view_phases.hpp"
#include "lippmann/optics/viewing.hpp"
#include "optics/lens_axis.hpp"
#include "optics/lens_cells.hpp"

namespace lippmann {

class JsonFields;
struct OpticsKindInfo;

struct SampleGrid {
  double across_mm = 1.0, down_mm = 1.0;
};

struct OpticsFacts {
  std::optional<LensArray> lenses = {};
  std::optional<ViewTiles> tiles = {};
  std::optional<SensorLenses> sensor_lenses = {};
  Vec2i whole_pixels_per_lens{0};
  Vec2f window_size_mm{0.0f};
  Window window = {};
  float viewing_distance_mm = kInfinity;
  float eye_height_mm = 0.0f;
  float viewing_zone = 0.0f;
  float depth_budget_mm = kInfinity;
  Parallax parallax = {false, false};
  Vec2i view_counts{1, 1};
  SampleGrid samples = {};  ///< spacing of the samples of a view; for a slanted panel, spacing of its pixels
  double lens_step_mm = 0.0;
  bool single_view = false;
  bool views_by_angle = false;       ///< true: the eyes of the views are at equal angles; false: at equal distances
  bool repeats_beyond_zone = false;  ///< whether eyes beyond the viewing zone see pixels of neighbouring lenses
  /// Slanted panels only: shift of a lens to the right from one film row to the next, in film columns.
  std::optional<double> lens_columns_per_row = {};
  /// Factors of the lens blur along x and y. The sigma along an axis is the sigma across the lenses divided by the factor, in
  /// pixels or, for quilts, in views. 0: the lenses have no power along the axis.
  Vec2d crosstalk_pitch{0.0};
};

/// Returns the width that one pixel covers through its lens at depth z. It is the larger of two widths: the lens pitch, scaled
/// by the perspective of the viewing distance, and the pixel, magnified by the lens.
inline float lens_footprint_mm(float pitch_mm, float gap_mm, float viewing_distance_mm, float pixel_pitch_mm, float z_mm) {
  return std::max(pitch_mm * std::abs(1.0f - z_mm / viewing_distance_mm), std::abs(z_mm) * pixel_pitch_mm / gap_mm);
}

/// Returns the z where rays of lens arrays start: `chosen_mm` if it is finite, otherwise the viewing distance if it is finite,
/// otherwise 4 panel diagonals.
float front_of_lenses_mm(const Panel& panel, float viewing_distance_mm, float chosen_mm);

float lens_zone(float pitch_mm, float gap_mm, float viewing_distance_mm);

OpticsFacts facts_of_lenses(const Panel& panel, const LensArray& lenses, Vec2i whole_pixels_per_lens);

/// Returns the window, the viewing distance and the spacing of the samples of optics whose pixels lie in the plane z = 0.
OpticsFacts facts_of_window(const Panel& panel, float viewing_distance_mm);

int rounded_count(double samples);
inline int rounded_up_count(double samples) { return rounded_count(std::ceil(samples - 0.01)); }

std::vector<Vec2d> lens_eyes(Vec2i n, double eye_step_mm, double eye_height_mm);

enum class StepsWithin {
  kView,
  kLens,
};

/// The steps from a pixel to its neighbours in the same picture (a directional view or the pixels below one lens), and the
/// bounds of the picture.
struct StepRule {
  enum class Bounds { kPanel, kTile, kSheetLens, kSquareLens, kHexagon };

  Vec2f across{1.0f, 0.0f}, down{0.0f, 1.0f};
  Bounds bounds = Bounds::kPanel;
  LensAxis<float> columns{}, rows{};  ///< axes of the cells; a sheet has only `columns`, across its lenses
  float cosine = 1.0f, sine = 0.0f, inverse_cosine = 1.0f;  ///< cosine, sine and 1 / cosine of a sheet's slant
  Vec2i tile{1, 1}, last_tile{0, 0};                        ///< quilts: size of a tile, and (column, row) of the last tile
  int padding_top = 0;
};

/// The functions that every model must have. `panel` and `model` must pass check_model(), except in calls of kind_of(),
/// sub_pixels_of() and check_model().
template <class Model>
concept CompleteModel = requires(const Panel& panel, const Model& model, Model& read, nlohmann::ordered_json& json,
                                 const JsonFields& members, float mm, Vec2d share, StepsWithin within) {
  { kind_of(model) } -> std::convertible_to<std::string_view>;
  { sub_pixels_of(model) } -> std::convertible_to<int>;
  check_model(panel, model);
  /// write_model() writes the members of the model to JSON, and read_model() reads them back. If a member is missing or
  /// invalid, `members` throws Error.
  write_model(model, json);
  read_model(members, read);
  { facts_of(panel, model) } -> std::same_as<OpticsFacts>;
  { front_mm(panel, model, mm) } -> std::same_as<float>;
  make_rays(panel, model, mm);
  { footprint_mm(panel, model, mm) } -> std::same_as<Vec2f>;
  /// Returns the slope (right, up) of the direction to an eye, relative to the middle of the viewing zone. `share` is the
  /// position in the zone, from 0 (left or lower end) to 1.
  { zone_slope(panel, model, share) } -> std::same_as<Vec2d>;
  { step_rule(panel, model, within) } -> std::same_as<StepRule>;
};

/// Models with an inverse mapping: pixels_seeing(), and sight_of() for replay. sight_of() returns one of the types of AnySight
/// (models.hpp).
template <class Model>
concept HasInverse = requires(const Panel& panel, const Model& model, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  pixels_seeing(panel, model, point_mm, pixels);
  sight_of(panel, model);
};

/// Models whose directional views are pinhole cameras (view_cameras()).
template <class Model>
concept HasCameras = requires(const Panel& panel, const Model& model) {
  { cameras_of(panel, model) } -> std::same_as<std::optional<ViewCameras>>;
};

/// Models of calibrated panels, where every sub-pixel has a view phase (view_phases()).
template <class Model>
concept HasViewPhases = requires(const Model& model) {
  { view_phases_of(model) } -> std::same_as<ViewPhases>;
};

/// Models that can map a pixel's ray to its lens (optics/lens_cells.hpp).
template <class Model>
concept HasLensCells = requires(const Panel& panel, const Model& model) {
  { lens_cells_of(panel, model) } -> std::same_as<LensCells>;
};

/// Models whose lenses can be replaced by set_lenses(). Its arguments are the pitch across the lenses, the gap and the centre
/// of lens 0. It also sets the viewing distance to infinity.
template <class Model>
concept HasLenses = requires(Model& model, float mm, Vec2f offset_mm) {
  set_lenses(model, mm, mm, offset_mm);
};

/// Models that flags and job files can select. kind_info() describes how to make the model from parameters
/// (optics/optics_kind.hpp).
template <class Model>
concept HasKindInfo = requires(const Model& model) {
  { kind_info(model) } -> std::same_as<const OpticsKindInfo&>;
};

OpticsFacts optics_facts(const Optics& optics);

/// Returns a model of the same kind with other lenses, viewed from infinity, or nothing if the model has no lenses. `pitch_mm`
/// is measured across the lenses. The caller must adapt the panel.
std::optional<OpticsModel> with_lenses(OpticsModel model, float pitch_mm, float gap_mm, Vec2f offset_mm);

[[noreturn]] void throw_no_inverse();

}  // namespace lippmann
