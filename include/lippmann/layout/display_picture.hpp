// Makes the pictures of a display from views of any size: the print for a lenticular sheet or microlens array, a quilt, or the
// interlaced frame of a panel.
//
// Views are cropped or padded to the display's aspect ratio and resampled in linear light: reduced by area averaging, enlarged
// by a Lanczos filter (3 lobes). They spread evenly over the viewing zone, with view 0 at the left. Below each lens of a sheet
// their order is reversed.
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

/// A flip print shows one of several frames depending on the viewing angle. Below each lens, frame 0 is at the left.
struct FlipParams {
  std::vector<double> shares = {};  ///< width of each frame below a lens, in any common unit; empty: equal widths
  /// 0: hard transitions between frames. 1: each transition is as wide as the narrower of its two frames.
  double blend = 0.0;
};

/// Bleed and marks around a print, before it is cut.
struct PrintFinish {
  double bleed_mm = 0.0;  ///< how far the picture extends beyond each cut edge
  bool marks = false;     ///< adds a 10 mm margin with crop marks, targets, text, and alignment bands
  bool proof = false;     ///< makes only the middle square inch of the print, with unchanged pixels

  bool is_plain() const { return bleed_mm == 0.0 && !marks && !proof; }
};

struct DisplayPictureParams {
  std::optional<AspectFit> fit = {};  ///< none: default_fit()
  /// Interpolation between views. Native frames accept any filter. Other pictures accept all filters except kGaussian.
  /// Microlens arrays accept only kNearest.
  ViewFilter filter = ViewFilter::kNearest;
  double sigma_views = 0.5;             ///< standard deviation for kGaussian, in views
  std::optional<FlipParams> flip = {};  ///< only for lenticular sheets; none: a print with views
  bool mirror = false;                  ///< swaps left and right, for prints on the back of a sheet
  int turn_deg = 0;                     ///< clockwise: 0, 90, 180 or 270 degrees
  double view_shift_px = 0.0;           ///< see ViewFitter's constructor
  PrintFinish finish = {};              ///< only for lenticular sheets and microlens arrays
};

/// Picture to make for a display. Each value has the name of the format (formats/formats.hpp) that stores the picture.
enum class DisplayTarget { kIntegral, kQuilt, kNative };

/// Throws a usage Error naming `display` if `format` is not integral, quilt or native, or if the display has no such picture.
DisplayTarget display_target(const Display& display, std::string_view format);

/// Returns kStretch for native frames, because players for slanted panels accept views of any size, and kCrop for other
/// pictures.
AspectFit default_fit(DisplayTarget target);

/// Returns "native" for slanted panels, and "integral" for other displays.
std::string_view own_format(const Display& display);

class ViewFitter {
 public:
  /// `view_shift_px` moves the plane with zero disparity. The window that is cut from a view moves right by this many pixels
  /// from one column of views to the next, and up from one row to the next. Values above 0 bring the scene forward. kCrop and
  /// kStretch keep only the part that all windows share; kPad adds black edges.
  ///
  /// The arguments must outlive this object. Throws a usage Error if the strips below the lenses are narrower than 2 pixels or
  /// wider than the picture.
  ViewFitter(const Display& display, DisplayTarget target, AspectFit fit, const ThreadPool& pool, double view_shift_px = 0.0);

  /// `aspect` is width / height of the scene area that the view shows. `number` is the view's number in `grid` and determines
  /// the shift of the view. Throws Error if the view's size differs from the first view's, and a usage Error naming
  /// `view-shift` if the shifts leave less than half of the view.
  Picture fitted(const Picture& view, double aspect, int number = 0, ViewGrid grid = {1, 1});
  /// Fits all views of a light field in place.
  void fit(LightField& field);

  Vec2i size() const { return size_; }
  bool has_fitted() const { return original_.x > 0; }
  /// Returns for example "cropped from 4000x3000 to 2250x3000, shifted by 1.5 pixels from view to view, resized to 372x682".
  std::string description() const;
  /// Returns a description such as "the views have 45 pixels across for 248 lenses" if views behind lenses have less than half
  /// a pixel per lens; otherwise an empty string.
  std::string coarseness() const;

 private:
  Vec2d window_of(Vec2i view, double aspect) const;
  Vec2d window_in_all(Vec2i view, double aspect, ViewGrid grid) const;

  const Display& display_;
  DisplayTarget target_;
  AspectFit fit_;
  const ThreadPool& pool_;
  double view_shift_px_;
  Vec2i size_{0, 0};
  double lenses_ = 0.0;  ///< number of lenses across; 0: a picture without lenses
  /// Left edge of the first sample (first_) and distance between samples (step_), as fractions of the display's width.
  double first_ = 0.0, step_ = 1.0;
  double aspect_ = 1.0;  ///< of the display, or of the quilt's views
  Vec2i original_{0, 0};
  Vec2d window_{0.0};
};

/// Returns a display that is larger by bleed_mm on each side, with the lenses in the same places. For a print with
/// a bleed, pass the larger display to ViewFitter and display_picture().
Display with_bleed(const Display& display, double bleed_mm);

/// Makes the picture from views that a ViewFitter has fitted. Throws a usage Error if
///   - there is only one view, or more than one row of views (microlens arrays excepted);
///   - FlipParams::shares is given and does not have one element per frame;
///   - `finish` is set for a picture that is not a print, or a print is too small for a proof.
Picture display_picture(const LightField& field, const Display& display, DisplayTarget target,
                        const DisplayPictureParams& params, const ThreadPool& pool);

}  // namespace lippmann
