// Makes the pictures of a display from views of any size: the print for a sheet of lenses, a quilt, or a panel's native frame.
//
// Views are cropped or padded to the aspect ratio of the display and resampled in linear light to its resolution: by area
// averaging for reduction, by Lanczos (3 lobes) for enlargement. They spread evenly over the viewing zone, with view 0 at the
// left. Below the lenses of a sheet their order is reversed, with view N - 1 at the left. Results do not depend on the number
// of threads.
// number of threads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/interlace.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// How a view of another aspect ratio fills the display.
enum class AspectFit { kCrop, kPad, kStretch };

/// A flip print, which shows frames in place of views. Below each lens, frame 0 lies at the left.
struct FlipParams {
  std::vector<double> shares = {};  ///< width of each frame below a lens, > 0, in any unit; empty: equal widths
  double blend = 0.0;  ///< 0: hard transitions; 1: each transition spreads over the smaller of the two shares that it joins
};

/// Bleed and marks around the print for a sheet or an array, before it is cut.
struct PrintFinish {
  double bleed_mm = 0.0;  ///< extension of the picture beyond each cut edge
  bool marks = false;     ///< adds a 10 mm margin with crop marks, targets, text, and alignment bands
  bool proof = false;     ///< only the middle square inch of the print, with identical pixels

  bool is_plain() const { return bleed_mm == 0.0 && !marks && !proof; }
};

struct DisplayPictureParams {
  std::optional<AspectFit> fit = {};         ///< none: default_fit()
  ViewFilter filter = ViewFilter::kNearest;  ///< between views; kGaussian for native frames only, arrays take kNearest only
  double sigma_views = 0.5;                  ///< of kGaussian
  std::optional<FlipParams> flip = {};       ///< sheets only
  bool mirror = false;                       ///< flips left and right, for prints on the back of a sheet
  int turn_deg = 0;                          ///< clockwise: 0, 90, 180 or 270
  double view_shift_px = 0.0;                ///< see ViewFitter
  PrintFinish finish = {};                   ///< sheets and arrays only
};

/// The kind of picture, named like the formats in layout/formats.hpp.
enum class DisplayTarget { kIntegral, kQuilt, kNative };

/// Returns the target of a format: integral, quilt or native. Throws a usage Error naming `display` if the display has no such
/// picture.
DisplayTarget display_target(const Display& display, std::string_view format);

/// Returns kStretch for native frames, whose views are sampled at their own size as the players of such panels do, and kCrop
/// for the others.
AspectFit default_fit(DisplayTarget target);

/// Returns the format of the display's own picture: native for slanted panels, integral for the others.
std::string_view own_format(const Display& display);

/// Fits views, one at a time, to the resolution and aspect ratio of a display.
class ViewFitter {
 public:
  /// view_shift_px moves the zero plane: the window shown moves right by this many pixels from each column of views to the
  /// next, relative to the middle view, and up from row to row. Values above 0 bring the scene forward. Crop and stretch keep
  /// only the part that all shifted views share; pad adds black edges.
  ///
  /// The arguments must outlive this object. Throws a usage Error for strips below 2 pixels or wider than the picture.
  ViewFitter(const Display& display, DisplayTarget target, AspectFit fit, const ThreadPool& pool, double view_shift_px = 0.0);

  /// Returns one view fitted. `aspect`: width / height of the scene area that the view shows. `number`: the view's number in
  /// `grid`, for its shift. Throws Error if its size differs from the first view's, and a usage Error naming `view-shift` if
  /// the shifts leave less than half of it.
  Picture fitted(const Picture& view, double aspect, int number = 0, ViewGrid grid = {1, 1});
  /// Fits each view of a light field in memory.
  void fit(LightField& field);

  Vec2i size() const { return size_; }
  bool has_fitted() const { return original_.x > 0; }
  /// Returns a description such as "cropped from 4000x3000 to 2250x3000, shifted by 1.5 pixels from view to view, resized to
  /// 372x682".
  std::string description() const;

 private:
  Vec2d window_of(Vec2i view, double aspect) const;
  Vec2d window_in_all(Vec2i view, double aspect, ViewGrid grid) const;

  const Display& display_;
  DisplayTarget target_;
  AspectFit fit_;
  const ThreadPool& pool_;
  double view_shift_px_;
  Vec2i size_{0, 0};
  double first_ = 0.0, step_ = 1.0;  ///< start of the first sample and width of each sample, as shares of the display's width
  double aspect_ = 1.0;              ///< of the display
  Vec2i original_{0, 0};
  Vec2d window_{0.0};
};

/// Returns the display enlarged on all sides, with its lenses in place. Pass it to ViewFitter and display_picture instead of
/// the display if DisplayPictureParams::finish has a bleed.
Display with_bleed(const Display& display, double bleed_mm);

/// Returns the picture of a display from views fitted by a ViewFitter. Throws a usage Error for views in more than one row, a
/// single view, a number of flip shares that differs from the number of frames, a finish on pictures that are not prints, and a
/// proof of a print that is not larger than the proof.
Picture display_picture(const LightField& field, const Display& display, DisplayTarget target,
                        const DisplayPictureParams& params, const ThreadPool& pool);

}  // namespace lippmann
