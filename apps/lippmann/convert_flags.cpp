#include "apps/lippmann/convert_flags.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "formats/light_field_source.hpp"
#include "formats/rendered.hpp"
#include "formats/rgbd_name.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/formats/kept_data.hpp"
#include "lippmann/formats/quilt_name.hpp"
#include "lippmann/layout/display_picture.hpp"
#include "replay/depth_frames.hpp"
#include "replay/no_light_field.hpp"
#include "video/video_reader.hpp"

namespace lippmann::app {
namespace {

struct IdleRule {
  const char* flag;
  bool (*is_given)(const ConvertOptions&);
  bool (*has_effect)(const ConvertOptions&, const Conversion&);
  const char* accepted;
};

template <bool FormatUses::*use>
bool is_read(const Conversion& c) {
  return c.from && c.from->reads.*use;
}
template <bool FormatUses::*use>
bool is_written(const Conversion& c) {
  return c.to && c.to->writes.*use;
}

bool reads_plenoptic(const ConvertOptions&, const Conversion& c) {
  return is_read<&FormatUses::plenoptic>(c) && c.kind != ConvertKind::kStereo;
}

bool has_formats(const ConvertOptions&, const Conversion& c) { return c.to != nullptr; }
bool is_for_display(const ConvertOptions&, const Conversion& c) { return c.kind == ConvertKind::kDisplay; }
bool is_rearranged(const ConvertOptions& o, const Conversion& c) {
  return c.kind == ConvertKind::kRearrange || is_for_display(o, c);
}
bool is_print(const ConvertOptions& o, const Conversion& c) { return is_for_display(o, c) && c.to->name == "integral"; }
bool is_flip(const ConvertOptions& o, const Conversion& c) { return is_print(o, c) && o.picture.flip; }
bool is_spoc(const ConvertOptions&, const Conversion& c) { return c.kind == ConvertKind::kSpoc; }
bool is_precompensation(const ConvertOptions&, const Conversion& c) { return c.kind == ConvertKind::kPrecompensate; }
bool is_stereo(const ConvertOptions&, const Conversion& c) { return c.kind == ConvertKind::kStereo; }
bool makes_depth_views(const Conversion& c) { return c.kind == ConvertKind::kDepthViews && c.to->name != "rgbd"; }
bool makes_stereo(const Conversion& c) { return c.to && c.to->name == "stereo"; }

bool keeps_cameras(const ConvertOptions&, const Conversion& c) {
  return c.kind == ConvertKind::kRearrange && keeps(c.to->name, DataKind::kCameras);
}

/// Returns whether both formats number views in the same order, so that the shape of the grid does not matter.
bool keeps_order(const Conversion& c) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kPairs{
      {{"views", "views"}, {"quilt", "quilt"}, {"quilt", "views"}, {"hci", "hci"}}};
  return std::find(kPairs.begin(), kPairs.end(), std::pair(c.from->name, c.to->name)) != kPairs.end();
}

bool uses_views(const ConvertOptions& options, const Conversion& c) {
  if (c.kind == ConvertKind::kDepthViews) return makes_depth_views(c) && !makes_stereo(c);
  if (c.is_from_video) return true;
  return is_read<&FormatUses::views>(c) && (!options.keep.empty() || !keeps_order(c));
}

bool uses_tiles(const ConvertOptions& o, const Conversion& c) {
  return is_read<&FormatUses::tiles>(c) || (is_written<&FormatUses::tiles>(c) && !is_for_display(o, c));
}

/// Flip prints show one frame at a time, so they have no filter between views.
bool uses_filter(const ConvertOptions& o, const Conversion& c) {
  return is_written<&FormatUses::filter>(c) || (is_for_display(o, c) && !o.picture.flip);
}

bool uses_display(const ConvertOptions& o, const Conversion& c) {
  if (is_for_display(o, c)) return true;
  if (c.kind == ConvertKind::kPrecompensate || makes_depth_views(c)) return true;
  return is_read<&FormatUses::display>(c) || is_written<&FormatUses::display>(c);
}

bool uses_view_angle(const ConvertOptions& options, const Conversion& c) {
  return c.kind == ConvertKind::kStereo || (makes_depth_views(c) && !makes_stereo(c) && options.display.empty()) ||
         options.sheet.pitch_depends_on_angle(options.stereo.viewing_distance_mm.has_value());
}

constexpr std::array kIdleRules{
    IdleRule{"--from", [](const ConvertOptions& o) { return !o.from.empty(); }, has_formats, "--to"},
    IdleRule{"--to", [](const ConvertOptions& o) { return !o.to.empty(); }, has_formats,
             "a conversion without --rotate-elemental, --spoc and --precompensate"},
    IdleRule{"--views", [](const ConvertOptions& o) { return !o.views.empty(); }, uses_views,
             "--from integral, eslf, plenoptic, views, quilt, hci or native to a format with another order of views, or RGB-D "
             "pictures"},
    IdleRule{"--quilt", [](const ConvertOptions& o) { return !o.quilt.empty(); }, uses_tiles, "--from quilt or --to quilt"},
    IdleRule{"--aspect", [](const ConvertOptions& o) { return o.aspect > 0.0; },
             [](const ConvertOptions& o, const Conversion& c) {
               return is_written<&FormatUses::aspect>(c) && !is_for_display(o, c);
             },
             "--to quilt without --display"},
    IdleRule{"--keep", [](const ConvertOptions& o) { return !o.keep.empty(); }, is_rearranged, "--to with a format"},
    IdleRule{"--crop", [](const ConvertOptions& o) { return !o.crop.empty(); }, is_rearranged, "--to with a format"},
    IdleRule{"--bits", [](const ConvertOptions& o) { return o.bits > 0; },
             [](const ConvertOptions& o, const Conversion& c) { return is_written<&FormatUses::bits>(c) && !o.png; },
             "--to jpeg-pleno without --png"},
    IdleRule{"--png", [](const ConvertOptions& o) { return o.png; },
             [](const ConvertOptions&, const Conversion& c) { return is_written<&FormatUses::bits>(c); }, "--to jpeg-pleno"},
    IdleRule{"--binary", [](const ConvertOptions& o) { return o.binary; },
             [](const ConvertOptions&, const Conversion& c) { return is_written<&FormatUses::binary>(c); }, "--to colmap"},
    IdleRule{"--display", [](const ConvertOptions& o) { return !o.display.empty(); }, uses_display,
             "--from native, --to native, integral or quilt, --precompensate, or RGB-D pictures"},
    IdleRule{"--fit", [](const ConvertOptions& o) { return !o.picture.fit.empty(); }, is_for_display, "--display"},
    IdleRule{"--view-shift", [](const ConvertOptions& o) { return o.picture.view_shift_px.has_value(); },
             [](const ConvertOptions& o, const Conversion& c) { return is_for_display(o, c) && !o.picture.flip; },
             "--display, of views"},
    IdleRule{"--mirror", [](const ConvertOptions& o) { return o.picture.mirror; }, is_print,
             "the --display of a sheet or an array of lenses"},
    IdleRule{"--rotate", [](const ConvertOptions& o) { return o.picture.turn_deg.has_value(); }, is_print,
             "the --display of a sheet or an array of lenses"},
    IdleRule{"--icc", [](const ConvertOptions& o) { return !o.picture.icc.empty(); }, is_print,
             "the --display of a sheet or an array of lenses"},
    IdleRule{"--bleed-mm", [](const ConvertOptions& o) { return o.picture.bleed_mm.has_value(); }, is_print,
             "the --display of a sheet or an array of lenses"},
    IdleRule{"--marks", [](const ConvertOptions& o) { return o.picture.marks; }, is_print,
             "the --display of a sheet or an array of lenses"},
    IdleRule{"--proof", [](const ConvertOptions& o) { return o.picture.proof; }, is_print,
             "the --display of a sheet or an array of lenses"},
    IdleRule{"--flip", [](const ConvertOptions& o) { return o.picture.flip; }, is_print, "the --display of a sheet"},
    IdleRule{"--shares", [](const ConvertOptions& o) { return !o.picture.shares.empty(); }, is_flip, "--flip"},
    IdleRule{"--blend", [](const ConvertOptions& o) { return o.picture.blend.has_value(); }, is_flip, "--flip"},
    IdleRule{"--filter", [](const ConvertOptions& o) { return !o.filter.filter.empty(); }, uses_filter,
             "--display, --to native"},
    IdleRule{"--sigma", [](const ConvertOptions& o) { return o.filter.sigma > 0.0; },
             [](const ConvertOptions& o, const Conversion& c) {
               return is_written<&FormatUses::filter>(c) && o.filter.filter == "gaussian";
             },
             "--to native with --filter gaussian"},
    IdleRule{"--reference-plane", [](const ConvertOptions& o) { return o.orthoscopic.reference_mm.has_value(); }, is_spoc,
             "--spoc"},
    IdleRule{"--lens-pitch", [](const ConvertOptions& o) { return o.orthoscopic.lens_pitch_mm.has_value(); }, is_spoc,
             "--spoc"},
    IdleRule{"--gap", [](const ConvertOptions& o) { return o.orthoscopic.gap_mm.has_value(); }, is_spoc, "--spoc"},
    IdleRule{"--lens-pixels", [](const ConvertOptions& o) { return o.orthoscopic.lens_pixels.has_value(); }, is_spoc, "--spoc"},
    IdleRule{"--white", [](const ConvertOptions& o) { return !o.plenoptic.white.empty(); }, reads_plenoptic,
             "--from plenoptic"},
    IdleRule{"--lens-pitch-px", [](const ConvertOptions& o) { return o.plenoptic.pitch_px.has_value(); }, reads_plenoptic,
             "--from plenoptic"},
    IdleRule{"--lens-row-pitch-px", [](const ConvertOptions& o) { return o.plenoptic.row_pitch_px.has_value(); },
             reads_plenoptic, "--from plenoptic, to a format other than stereo"},
    IdleRule{"--lens-rotation", [](const ConvertOptions& o) { return o.plenoptic.rotation_deg.has_value(); }, reads_plenoptic,
             "--from plenoptic"},
    IdleRule{"--lens-offset", [](const ConvertOptions& o) { return !o.plenoptic.offset.empty(); }, reads_plenoptic,
             "--from plenoptic"},
    IdleRule{"--lens-arrangement", [](const ConvertOptions& o) { return !o.plenoptic.arrangement.empty(); }, reads_plenoptic,
             "--from plenoptic"},
    IdleRule{"--sampling", [](const ConvertOptions& o) { return !o.plenoptic.sampling.empty(); }, reads_plenoptic,
             "--from plenoptic"},
    IdleRule{"--inverted", [](const ConvertOptions& o) { return o.plenoptic.inverted; }, reads_plenoptic,
             "--from plenoptic, to a format other than stereo"},
    IdleRule{"--crosstalk", [](const ConvertOptions& o) { return !o.crosstalk.crosstalk.empty(); }, is_precompensation,
             "--precompensate"},
    IdleRule{"--stereo", [](const ConvertOptions& o) { return !o.stereo.packing.empty(); },
             [](const ConvertOptions&, const Conversion& c) {
               return is_read<&FormatUses::stereo>(c) || is_written<&FormatUses::stereo>(c);
             },
             "--to stereo or --from stereo"},
    IdleRule{"--right-first", [](const ConvertOptions& o) { return o.stereo.right_first; },
             [](const ConvertOptions&, const Conversion& c) {
               return is_read<&FormatUses::stereo>(c) || is_written<&FormatUses::stereo>(c);
             },
             "--to stereo or --from stereo"},
    IdleRule{"--ipd", [](const ConvertOptions& o) { return o.stereo.ipd_mm.has_value(); },
             [](const ConvertOptions&, const Conversion& c) { return c.kind != ConvertKind::kRearrange && makes_stereo(c); },
             "--to stereo, of more than two views"},
    IdleRule{"--viewing-distance", [](const ConvertOptions& o) { return o.stereo.viewing_distance_mm.has_value(); },
             [](const ConvertOptions& o, const Conversion& c) { return is_stereo(o, c) || o.sheet.are_given(); },
             "--to stereo, of more than two views, or --lpi"},
    IdleRule{"--screen-width", [](const ConvertOptions& o) { return o.stereo.screen_width_mm.has_value(); }, is_stereo,
             "--to stereo, of more than two views"},
    IdleRule{"--view-angle", [](const ConvertOptions& o) { return o.stereo.view_angle_deg.has_value(); }, uses_view_angle,
             "--to stereo, --lpi with --viewing-distance, or RGB-D pictures converted to views without --display"},
    IdleRule{"--depth", [](const ConvertOptions& o) { return !o.depth.map.empty(); },
             [](const ConvertOptions&, const Conversion& c) { return c.kind == ConvertKind::kDepthViews; },
             "a picture, without --keep and --crop"},
    IdleRule{"--depth-range", [](const ConvertOptions& o) { return !o.depth.range.empty(); },
             [](const ConvertOptions&, const Conversion& c) {
               return is_read<&FormatUses::depth_coding>(c) || is_written<&FormatUses::depth_coding>(c);
             },
             "--from rgbd or --to rgbd"},
    IdleRule{"--depth-coding", [](const ConvertOptions& o) { return !o.depth.coding.empty(); },
             [](const ConvertOptions&, const Conversion& c) {
               return is_read<&FormatUses::depth_coding>(c) || is_written<&FormatUses::depth_coding>(c);
             },
             "--from rgbd or --to rgbd"},
    IdleRule{"--near-black", [](const ConvertOptions& o) { return o.depth.near_black; },
             [](const ConvertOptions&, const Conversion& c) {
               return is_read<&FormatUses::depth_coding>(c) || is_written<&FormatUses::depth_coding>(c);
             },
             "--from rgbd or --to rgbd"},
    IdleRule{"--depth-scale", [](const ConvertOptions& o) { return o.depth.scale.has_value(); },
             [](const ConvertOptions&, const Conversion& c) { return makes_depth_views(c); },
             "RGB-D or stereo pictures converted to views, without --keep and --crop"},
};

bool makes_display_picture(const ConvertOptions& options, const Conversion& c) {
  const std::string_view to = c.to->name;
  return options.has_display() && c.from->name != "native" && (to == "integral" || to == "quilt" || to == "native");
}

/// Returns whether IN is a video with one view per frame. Throws Error if its frames hold all views.
bool is_video_of_views(const ConvertOptions& options) {
  if (!is_video_name(options.in) || !(options.from.empty() || options.from == "views")) return false;
  if (options.from.empty() && (parse_quilt_name(options.in) || rendering_of(options.in)))
    throw Error(options.in, "each frame of this video holds several views",
                "the folder of frames that it was made from, or --from views to read each frame as one view");
  if (options.to == "stereo")
    throw usage_error("--to", "stereo cannot be made from the frames of a video in one step",
                      "--to views, then a second conversion of these views with --to stereo");
  return true;
}

/// Sets the format of IN. A picture with a depth map counts as RGB-D.
void find_source(const ConvertOptions& options, Conversion& conversion) {
  const bool from_rgbd =
      options.from == "rgbd" || (options.from.empty() && (!options.depth.map.empty() || is_rgbd(options.in)));
  conversion.is_from_video = !from_rgbd && is_video_of_views(options);
  if (!from_rgbd && !conversion.is_from_video && options.from.empty()) require_light_field(options.in);
  if (from_rgbd)
    conversion.from = &find_format("rgbd", "--from");
  else
    conversion.from =
        conversion.is_from_video ? &find_format("views", "--from") : &format_of_light_field(options.in, options.from);
}

bool makes_views_of_depth(const ConvertOptions& options, const Conversion& c) {
  return c.from->name == "rgbd" && (!options.depth.map.empty() || c.to->name != "rgbd");
}

/// Returns whether to compute new views from a stereo picture. The flag --views requests them.
bool makes_views_of_pair(const ConvertOptions& options, const Conversion& c) {
  return c.from->name == "stereo" && c.to->name != "stereo" && c.to->name != "rgbd" && !options.views.empty();
}

std::string described(const Conversion& conversion) {
  switch (conversion.kind) {
    case ConvertKind::kRotate:
      return "has no effect with --rotate-elemental";
    case ConvertKind::kSpoc:
      return "has no effect with --spoc";
    case ConvertKind::kPrecompensate:
      return "has no effect with --precompensate";
    default:
      return fmt::format("has no effect on a conversion from {} to {}", conversion.from->name, conversion.to->name);
  }
}

}  // namespace

Display ConvertOptions::read_display() const {
  if (!sheet.are_given()) return load_display(display);
  const auto text_of = [](const std::optional<double>& number) { return number ? fmt::format("{}", *number) : std::string(); };
  return load_display(sheet.line({display, text_of(stereo.viewing_distance_mm), text_of(stereo.view_angle_deg)}));
}

Conversion conversion_of(const ConvertOptions& options) {
  const OrthoscopicFlags& orthoscopic = options.orthoscopic;
  if (orthoscopic.rotate_elemental && orthoscopic.spoc_mm)
    throw usage_error("--spoc", "cannot be combined with --rotate-elemental", "one of the two");
  if (orthoscopic.are_given() && options.crosstalk.precompensate)
    throw usage_error("--precompensate", "cannot be combined with --rotate-elemental or --spoc",
                      "two conversions, one after the other");
  if (orthoscopic.are_given()) return {orthoscopic.spoc_mm ? ConvertKind::kSpoc : ConvertKind::kRotate};
  if (options.crosstalk.precompensate) return {ConvertKind::kPrecompensate};
  if (options.to.empty() && !options.crosstalk.crosstalk.empty())
    throw usage_error("--crosstalk", "has no effect without --precompensate", "--precompensate");
  if (options.to.empty() && !options.has_display())
    throw usage_error("--to", "is required", "a format (see --help), --display, --rotate-elemental, --spoc or --precompensate");
  Conversion conversion;
  conversion.to =
      options.to.empty() ? &find_format(own_format(options.read_display()), "--to") : &find_output_format(options.to, "--to");
  if (!options.depth.map.empty() && (!options.from.empty() || has_rgbd_name(options.in)))
    throw usage_error("--depth",
                      options.from.empty()
                          ? "cannot be combined with " + options.in + ", whose name states that it contains depth"
                          : "cannot be combined with --from",
                      "a picture whose depth is in a separate file");
  find_source(options, conversion);
  const bool is_whole = options.keep.empty() && options.crop.empty();
  if (is_whole && (makes_views_of_depth(options, conversion) || makes_views_of_pair(options, conversion)))
    conversion.kind = ConvertKind::kDepthViews;
  else if (makes_display_picture(options, conversion))
    conversion.kind = ConvertKind::kDisplay;
  else if (is_whole && options.to == "stereo" && conversion.from->name != "stereo")
    conversion.kind = ConvertKind::kStereo;
  return conversion;
}

void refuse_idle_flags(const ConvertOptions& options, const Conversion& conversion) {
  if (options.sheet.are_given() && !uses_display(options, conversion))
    throw usage_error(options.sheet.first_given(), described(conversion), "--to integral, or RGB-D pictures");
  if (const char* flag = options.cameras.first_given(); flag && !keeps_cameras(options, conversion))
    throw usage_error(flag, described(conversion), "--to hci, miv, stanford, eslf or another format that holds cameras");
  for (const IdleRule& rule : kIdleRules)
    if (rule.is_given(options) && !rule.has_effect(options, conversion))
      throw usage_error(rule.flag, described(conversion), rule.accepted);
}

}  // namespace lippmann::app
