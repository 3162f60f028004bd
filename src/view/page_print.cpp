#include "view/page_print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "image/png.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/image/encode.hpp"
#include "view/answers.hpp"
#include "view/field_json.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPrintEffort = 0;  ///< lowest compression effort, because a client waits for the views
constexpr double kMaxShiftPx = 1e4;

Display display_of_text(const JsonFields& file) {
  const std::string name = file.text("name"), text = file.text("text");
  file.allow_only({"name", "text"});
  Display display = name.ends_with(".toml") ? display_from_toml(text, name) : display_from_calibration(text, name);
  display.name = name;
  return display;
}

Display display_of_name(const std::string& name) {
  if (is_display_file(name))
    throw usage_error("display", "there is no display '" + name + "'",
                      "a name of `lippmann displays`, or a sheet such as lpi=60 dpi=600 paper=A5");
  return load_display(name);
}

void require_size(const Display& display) {
  const double pixels = static_cast<double>(display.pixels.x) * display.pixels.y;
  if (pixels > kMaxPrintPixels)
    throw usage_error(
        "display", fmt::format("the print has {}x{} pixels, {:.0f} million", display.pixels.x, display.pixels.y, 1e-6 * pixels),
        fmt::format("up to {:.0f} million; `lippmann convert` makes larger ones", 1e-6 * kMaxPrintPixels));
}

Image8 codes_of(const Picture& picture) {
  if (const auto* codes = std::get_if<Image8>(&picture)) return *codes;
  return to_codes(to_linear(picture), Encoding::kSrgb);
}

Bytes shared_bytes(std::string bytes) { return std::make_shared<const std::string>(std::move(bytes)); }

}  // namespace

struct PagePrints::Print {
  std::size_t id = 0;
  Image8 picture;
  double dpi = 0.0;
  Bytes views;
};

PrintRequest read_print_request(const std::string& text) {
  const Json json = json_from_text(text);
  if (!json.is_object()) throw Error("The settings of the print", "are not a JSON object");
  const JsonFields fields(json, {}, {});
  PrintRequest request;
  request.frame = static_cast<std::size_t>(fields.whole_or("frame", {0.0, 1e9}, 0));
  request.view_shift_px = fields.number_or("view_shift_px", {-kMaxShiftPx, kMaxShiftPx}, 0.0);
  if (fields.has("fit")) request.fit = static_cast<AspectFit>(fields.word("fit", {"crop", "pad", "stretch"}));
  request.display = fields.has("file") ? display_of_text(fields.inner("file")) : display_of_name(fields.text("display"));
  fields.allow_only({"frame", "display", "file", "fit", "view_shift_px"});
  require_size(request.display);
  return request;
}

PagePrints::PagePrints(const PageField& field) : field_(field), pool_(field.threads()) {}

Json PagePrints::make(const std::string& request) {
  const std::unique_lock making(making_, std::try_to_lock);
  if (!making) throw Error("print", "another print is being made", "trying again when the other print is finished");
  const PrintRequest wanted = read_print_request(request);
  if (wanted.frame >= field_.facts().frames.size()) throw usage_error("frame", "there is no such frame");
  {
    const std::lock_guard lock(mutex_);
    last_.reset();  // releases the last print, because two might not fit into memory
  }
  const Display& display = wanted.display;
  const DisplayTarget target = display_target(display, own_format(display));
  ViewFitter fitter(display, target, wanted.fit.value_or(default_fit(target)), pool_, wanted.view_shift_px);
  LightField views = field_.views(wanted.frame, [&](const Picture& view, double aspect, int number, ViewGrid grid) {
    return fitter.fitted(view, aspect, number, grid);
  });
  if (!fitter.has_fitted()) fitter.fit(views);
  const Picture picture = display_picture(views, display, target, {}, pool_);

  auto print = std::make_shared<Print>();
  print->picture = codes_of(picture), print->dpi = display.dpi;
  const RenderedPanel behind_lenses{native_optics(display), to_linear(picture)};
  PageFacts facts = page_facts(behind_lenses.optics);
  facts.title = display.description;
  facts.frames = {field_.facts().frames[wanted.frame]};
  print->views = shared_bytes(encoded_picture(views_quilt(behind_lenses, facts, pool_, display.name), kPrintEffort).bytes);
  {
    const std::lock_guard lock(mutex_);
    print->id = ++made_;
    last_ = print;
  }
  return {{"id", print->id},
          {"description", display.description},
          {"fitted", fitter.description()},
          {"pixels", {print->picture.width, print->picture.height}},
          {"field", field_json(facts)}};
}

std::shared_ptr<const PagePrints::Print> PagePrints::kept() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

Bytes PagePrints::picture(std::string_view kind, std::size_t id) const {
  const std::shared_ptr<const Print> print = kept();
  if (!print || print->id != id) return nullptr;
  if (kind == "views") return print->views;
  if (kind == "panel") return shared_bytes(encoded_picture(print->picture, kPrintEffort).bytes);
  if (kind != "file") return nullptr;
  PngOptions png;
  png.dots_per_inch = print->dpi;
  const std::vector<std::byte> bytes = encode_png(print->picture, png);
  return shared_bytes({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

bool PagePrints::is_outdated(std::size_t id) const {
  const std::lock_guard lock(mutex_);
  return id >= 1 && id <= made_ && !(last_ && last_->id == id);
}

}  // namespace lippmann
