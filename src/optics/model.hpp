// What a model of optics answers. Every model has one header that declares all of it, as functions that take the model:
// lenticular.hpp, microlens.hpp, multi_view.hpp, single_view.hpp, slanted_panel.hpp, ray_table.hpp. models.hpp lists the models
// and has the compiler check the answers; what the optics as a whole say (lippmann/optics/*.hpp) is made of them, here and
// nowhere else.
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

class JsonFields;       // core/json_fields.hpp
struct OpticsKindInfo;  // optics/optics_kind.hpp

/// How far apart the samples of a view are in the plane z = 0: to the right and down.
struct SampleGrid {
  double across_mm = 1.0, down_mm = 1.0;
};

/// What a model has to say that depends on no pixel and no point. Made once; other numbers are derived from these.
struct OpticsFacts {
  std::optional<LensArray> lenses = {};
  std::optional<ViewTiles> tiles = {};
  Vec2i whole_pixels_per_lens{0};  ///< see whole_pixels_per_lens()
  Vec2f window_size_mm{0.0f};      ///< the panel's, or one view's
  Window window = {};              ///< the same as it is seen by the viewer
  float viewing_distance_mm = kInfinity;
  float eye_height_mm = 0.0f;  ///< how far the viewer's eyes are above the middle of the array
  float viewing_zone = 0.0f;
  float depth_budget_mm = kInfinity;
  Parallax parallax = {false, false};
  Vec2i view_counts{1, 1};
  SampleGrid samples = {};        ///< a view's; on a slanted panel, its whole pixels
  double lens_step_mm = 0.0;      ///< from one sample of a view to the next along a row, where that is a lens; else 0
  bool single_view = false;       ///< see is_single_view()
  bool views_by_angle = false;    ///< the eyes of its views are equally far apart in angle, not in the plane that they stand in
  bool next_lens_beyond = false;  ///< beyond the zone, an eye sees what belongs to the neighbouring lens
  std::optional<double> lens_columns_per_row = {};  ///< film columns by which a lens moves to the right from row to row; none
                                                    ///< but for slanted lenses without whole pixels on a film of sub-pixels
  Vec2d crosstalk_pitch{0.0};  ///< pixels (views) of the panel along x and y that are one across the lenses; 0: no power
};

/// The footprint of a lens: its pitch, seen in perspective from the viewing distance, or the magnified pixel, whichever is
/// wider.
inline float lens_footprint_mm(float pitch_mm, float gap_mm, float viewing_distance_mm, float pixel_pitch_mm, float z_mm) {
  return std::max(pitch_mm * std::abs(1.0f - z_mm / viewing_distance_mm), std::abs(z_mm) * pixel_pitch_mm / gap_mm);
}

/// Where rays of lenses start: as chosen; else at the viewing distance, or well in front of the panel.
float front_of_lenses_mm(const Panel& panel, float viewing_distance_mm, float chosen_mm);

/// The viewing zone of lenses.
float lens_zone(float pitch_mm, float gap_mm, float viewing_distance_mm);

/// The facts that all lens arrays have in common.
OpticsFacts facts_of_lenses(const Panel& panel, const LensArray& lenses, Vec2i whole_pixels_per_lens);

/// The facts that all panels without lenses in front of the display plane have in common: their window, of square pixels, and
/// the samples of a view in it.
OpticsFacts facts_of_window(const Panel& panel, float viewing_distance_mm);

/// Whole samples: at least one, and not more than a panel's side can have.
int rounded_count(double samples);
inline int rounded_up_count(double samples) { return rounded_count(std::ceil(samples - 0.01)); }

/// The eyes of n pixels below a lens, from the lower left one, eye_step_mm apart.
std::vector<Vec2d> lens_eyes(Vec2i n, double eye_step_mm, double eye_height_mm);

enum class StepsWithin {
  kView,  ///< the same directional view
  kLens,  ///< below the same lens
};

/// The way from a pixel to its neighbours in one picture, and where that picture ends.
struct StepRule {
  enum class Bounds { kPanel, kTile, kSheetLens, kSquareLens, kHexagon };

  Vec2f across{1.0f, 0.0f}, down{0.0f, 1.0f};  ///< film pixels
  Bounds bounds = Bounds::kPanel;
  LensAxis<float> columns{}, rows{};                        ///< the cells' axes; a sheet has only `columns`, along xi
  float cosine = 1.0f, sine = 0.0f, inverse_cosine = 1.0f;  ///< a sheet's slant
  Vec2i tile{1, 1}, last_tile{0, 0};                        ///< a quilt's tiles: their size, and column and row of the last one
  int padding_top = 0;
};

/// Every model answers these. `panel` and `model` must pass check_model(), but for kind_of, sub_pixels_of and check_model
/// itself.
template <class Model>
concept AnswersForItself = requires(const Panel& panel, const Model& model, Model& read, nlohmann::ordered_json& json,
                                    const JsonFields& members, float mm, Vec2d share, StepsWithin within) {
  /// Its name in report.json.
  { kind_of(model) } -> std::convertible_to<std::string_view>;
  /// Film pixels side by side in one pixel of the panel.
  { sub_pixels_of(model) } -> std::convertible_to<int>;
  /// Throws Error naming the field that makes no rays.
  check_model(panel, model);
  /// As JSON and back, panel and depths apart. Reading throws Error by way of `members`.
  write_model(model, json);
  read_model(members, read);
  /// Everything else that depends on no pixel.
  { facts_of(panel, model) } -> std::same_as<OpticsFacts>;
  /// resolved_z_front_mm() for z_front_mm = mm.
  { front_mm(panel, model, mm) } -> std::same_as<float>;
  /// The constants of its rays, one of AnyRays (models.hpp), or a variant of several of these.
  make_rays(panel, model, mm);
  /// sample_footprint_mm() at z = mm.
  { footprint_mm(panel, model, mm) } -> std::same_as<Vec2f>;
  /// How far beside the design viewer, in slope, an eye stands that far through the zone, to the right and up.
  { zone_slope(panel, model, share) } -> std::same_as<Vec2d>;
  /// Its neighbours.
  { step_rule(panel, model, within) } -> std::same_as<StepRule>;
};

/// Models whose lines can be followed backwards answer these, too: pixels_seeing(), and what an eye sees (replay), one of
/// AnySight (models.hpp). Where a model does not, the optics refuse what is made of it.
template <class Model>
concept HasInverse = requires(const Panel& panel, const Model& model, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  pixels_seeing(panel, model, point_mm, pixels);
  sight_of(panel, model);
};

/// Models with directional views say where these are seen from (view_cameras()).
template <class Model>
concept HasCameras = requires(const Panel& panel, const Model& model) {
  { cameras_of(panel, model) } -> std::same_as<std::optional<ViewCameras>>;
};

/// Models of calibrated panels say which view each of their sub-pixels belongs to (view_phases()).
template <class Model>
concept HasViewPhases = requires(const Model& model) {
  { view_phases_of(model) } -> std::same_as<ViewPhases>;
};

/// Models of lenses say which of them the ray of a pixel goes through (optics/lens_cells.hpp).
template <class Model>
concept HasLensCells = requires(const Panel& panel, const Model& model) {
  { lens_cells_of(panel, model) } -> std::same_as<LensCells>;
};

/// Models of lenses can be given others: pitch across, gap, the centre of lens 0, seen from infinity.
template <class Model>
concept HasLenses = requires(Model& model, float mm, Vec2f offset_mm) {
  set_lenses(model, mm, mm, offset_mm);
};

/// Models that flags and job files can name say how parameters make them (optics/optics_kind.hpp).
template <class Model>
concept IsNamedByFlags = requires(const Model& model) {
  { kind_info(model) } -> std::same_as<const OpticsKindInfo&>;
};

/// What the model of these optics says.
OpticsFacts optics_facts(const Optics& optics);

/// The same film behind other lenses: `pitch_mm` across them, seen from infinity. None where there are no lenses. The panel is
/// the caller's to change.
std::optional<OpticsModel> with_lenses(OpticsModel model, float pitch_mm, float gap_mm, Vec2f offset_mm);

/// Throws a usage Error for optics without an inverse.
[[noreturn]] void refuse_without_inverse();

}  // namespace lippmann
