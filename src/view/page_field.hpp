// A light field in files as a page shows it: what it is in figures, and of every frame its views in one picture (a quilt), how
// far points move from view to view where depth is known, and what the panel shows.
//
// Whatever `find_light_field_frames` reads.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/replay/light_field_frames.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

class RunningRender;

class PageField {
 public:
  /// Throws Error naming the file, or the flag that has to say what nothing else says; depth that cannot be read is left out
  /// with a warning. Links that lead out of the folder that
  /// is shown are refused, those of frames when they are read.
  PageField(std::filesystem::path in, LightFieldHints hints, const Context& context);

  /// What a render's folder will hold: its report says the optics, and whether there is depth. Throws Error naming it. A frame
  /// that has not come yet is an Error when it is asked for.
  PageField(const std::filesystem::path& folder, std::shared_ptr<const RunningRender> coming, const Context& context);

  const PageFacts& facts() const { return facts_; }
  /// In place of the name of the files.
  void set_title(std::string title) { facts_.title = std::move(title); }

  // These are of the frame of that index, below facts().frames.size(). All throw Error naming the file; thread-safe.

  /// sRGB codes; facts().tiles of facts().view_size. With crosstalk (see views_quilt) as eyes see it through the panel's own.
  Image8 quilt(std::size_t frame, double crosstalk_px = 0.0) const;
  /// Likewise, codes of disparity. Needs facts().has_depth.
  Image8 disparities(std::size_t frame) const;
  /// Likewise, where each pixel came from: its number in Provenance, as red, green and blue. Needs facts().has_provenance.
  Image8 provenance(std::size_t frame) const;
  /// sRGB codes of facts().panel_size.
  Image8 panel(std::size_t frame) const;
  /// The views as the files have them. Needs has_plain_views(). `fit`: as FormatOptions::fit_view.
  LightField views(std::size_t frame, const std::function<Picture(const Picture&, int view, ViewGrid grid)>& fit) const;

  /// Whether files hold the pixels of two views or more, and all of them are there.
  bool has_plain_views() const;
  int threads() const { return pool_.threads(); }

 private:
  RenderedPanel read(std::size_t frame) const;
  std::filesystem::path file_of(std::size_t frame) const;
  /// The views with all layers that are there.
  struct Layered;
  Layered layered(std::size_t frame) const;
  /// Adds to the facts which layers the first frame has.
  void find_layers();
  Image8 in_quilt(const Image8& stack) const;

  LightFieldHints hints_;
  std::filesystem::path root_;  ///< before the frames: what leads out of it is not even looked at
  LightFieldFrames frames_;
  PageFacts facts_;
  ThreadPool pool_;
  std::shared_ptr<const RunningRender> coming_;  ///< null: all files are there
};

}  // namespace lippmann
