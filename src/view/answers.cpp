#include "view/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "core/json_text.hpp"
#include "image/png.hpp"
#include "image/webp.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/version.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "view/dropped_pictures.hpp"
#include "view/field_json.hpp"
#include "view/gzip.hpp"
#include "view/page_files.hpp"
#include "view/page_print.hpp"
#include "view/preview.hpp"
#include "view/saved_page.hpp"

namespace lippmann {
namespace {

/// Lowest compression effort, because a client waits for each image.
constexpr int kServedEffort = 0;
/// Largest blur of views that a page may request, in hundredths of a pixel.
constexpr auto kMaxCrosstalk = static_cast<std::size_t>(100.0 * kMaxBlurPx);
constexpr std::string_view kCalibration = "calibration", kLive = "live", kRun = "run", kPrint = "print", kDrop = "drop";

PageAnswer answer_with(int status, std::string text, std::string type = "text/plain; charset=utf-8") {
  return {status, std::move(type), std::make_shared<const std::string>(std::move(text))};
}

PageAnswer file_answer(const PageFile& file, bool compresses) {
  if (!compresses) return answer_with(200, std::string(file.text), std::string(file.type));
  PageAnswer answer = answer_with(200, gzip(file.text), std::string(file.type));
  answer.coding = "gzip";
  return answer;
}

PageAnswer unknown_path() { return answer_with(404, "There is nothing with this name.\n"); }

PageAnswer failed(const std::string& message) {
  return answer_with(422, json_to_text({{"error", message}}), "application/json");
}

/// Takes a time that depends only on the length, so that timing reveals nothing about a secret.
bool equal_secrets(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

std::string_view cut_part(std::string_view& path) {
  const std::size_t slash = path.find('/');
  const std::string_view part = path.substr(0, slash);
  path = slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1);
  return part;
}

std::optional<std::size_t> number_in(std::string_view text) {
  std::size_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || text.size() > 9 || problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Pages of other sites may request only the page itself (the empty path).
bool is_allowed_site(const std::string& fetch_site, std::string_view path) {
  return fetch_site.empty() || fetch_site == "same-origin" || fetch_site == "none" || path.empty();
}

std::string text_of(const std::vector<std::byte>& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

}  // namespace

PagePicture encoded_picture(const Image8& picture, int effort) {
  if (std::max(picture.width, picture.height) > kMaxWebpSide) return {text_of(encode_png(picture)), "image/png"};
  return {text_of(encode_webp(picture, effort)), "image/webp"};
}

PagePicture page_picture(const PageField& field, std::string_view kind, std::size_t frame, int effort) {
  if (kind == "views") return encoded_picture(field.quilt(frame), effort);
  if (kind == "preview") return {encoded_preview(field.quilt(frame), field.facts()), "image/webp"};
  if (kind == "depth") return encoded_picture(field.disparities(frame), effort);
  return encoded_picture(kind == "provenance" ? field.provenance(frame) : field.panel(frame), effort);
}

std::string fields_text(const std::vector<std::unique_ptr<PageField>>& fields, const std::optional<PageDisplay>& display,
                        PageOffers offers) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& field : fields) list.push_back(field_json(field->facts()));
  nlohmann::ordered_json json{{"lippmann", version()}, {"fields", std::move(list)}};
  if (display) json["display"] = page_display_json(*display);
  if (offers.drops) json["drops"] = true;
  if (offers.prints) {
    nlohmann::ordered_json displays = nlohmann::ordered_json::array();
    for (const Display& one : display_presets()) displays.push_back(one.name);
    json["prints"] = {{"displays", std::move(displays)}};
  }
  return json_to_text(json, -1);
}

PageAnswers::PageAnswers(std::vector<std::unique_ptr<PageField>> fields, PageAccess access, std::optional<PageDisplay> display,
                         std::size_t cache_bytes)
    : fields_(std::move(fields)), access_(std::move(access)), display_(std::move(display)), cache_(cache_bytes) {
  if (fields_.size() == 1 && fields_.front()->has_plain_views()) prints_ = std::make_shared<PagePrints>(*fields_.front());
}

PageAnswers::PageAnswers(std::unique_ptr<LivePage> live, PageAccess access)
    : live_(std::move(live)), access_(std::move(access)), cache_(0) {}

PageAnswers::PageAnswers(std::unique_ptr<PageField> field, std::shared_ptr<RunningRender> render, PageAccess access)
    : render_(std::move(render)), access_(std::move(access)), cache_(kDefaultCacheBytes) {
  fields_.push_back(std::move(field));
}

PageAnswers::PageAnswers(std::shared_ptr<DroppedPictures> dropped, PageAccess access)
    : dropped_(std::move(dropped)), access_(std::move(access)), cache_(0) {}

bool PageAnswers::takes_text(std::string_view path) const {
  const std::string_view part = path.substr(0, path.find('/'));
  if (dropped_ && part == kDrop) return true;
  if (const auto shown = dropped_ ? dropped_->shown() : nullptr) return shown->takes_text(path);
  return path == kCalibration || (path == kPrint && prints_) || (part == kLive && live_) || (part == kRun && render_);
}

std::optional<PageAnswer> PageAnswers::refusal(const PageRequest& request) const {
  const std::vector<std::string>& hosts = access_.hosts;
  if (!hosts.empty() && std::find(hosts.begin(), hosts.end(), request.host) == hosts.end())
    return answer_with(403, "This server answers at the address that `lippmann view` printed, and at no other name.\n");
  if (!request.origin.empty() && request.origin != "http://" + request.host)
    return answer_with(403, "Pages of other origins have no access.\n");
  if (!request.path.starts_with('/')) return unknown_path();
  std::string_view path = std::string_view(request.path).substr(1);
  if (!access_.token.empty() && !equal_secrets(cut_part(path), access_.token))
    return answer_with(403, "The address lacks the token that `lippmann view` printed with it.\n");
  if (!is_allowed_site(request.fetch_site, path)) return answer_with(403, "Pages of other origins have no access.\n");
  if (request.method == "GET" || request.method == "HEAD") return std::nullopt;
  if (request.method != "POST" || !takes_text(path)) return answer_with(405, "Only GET and HEAD are supported here.\n");
  if (path != kCalibration && request.origin.empty())
    return answer_with(403, "Only the page itself may change anything here.\n");
  return std::nullopt;
}

PageAnswer PageAnswers::answer(const PageRequest& request) {
  if (std::optional<PageAnswer> refused = refusal(request)) return *std::move(refused);
  std::string_view path = std::string_view(request.path).substr(1);
  if (!access_.token.empty()) cut_part(path);
  if (dropped_) return answer_drop(request, path);
  return request.method == "POST" ? answer_text(request, path) : answer_path(request, path);
}

/// Answers POSTs of dropped images, and GET fields.json. The PageAnswers object of the shown images answers all other
/// requests.
PageAnswer PageAnswers::answer_drop(const PageRequest& request, std::string_view path) {
  const bool is_text = request.method == "POST";
  const std::shared_ptr<PageAnswers> shown = dropped_->shown();
  if (path == "fields.json" && !is_text) {
    const bool prints = shown && shown->prints_;
    return answer_with(200, fields_text(shown ? shown->fields_ : fields_, {}, {.prints = prints, .drops = true}),
                       "application/json");
  }
  std::string_view rest = path;
  if (!is_text || cut_part(rest) != kDrop) {
    PageAnswers& answers = shown ? *shown : *this;
    return is_text ? answers.answer_text(request, path) : answers.answer_path(request, path);
  }
  try {
    dropped_->post(rest, request.body);
    return answer_with(200, json_to_text({{"received", request.body.size()}}, -1), "application/json");
  } catch (const Error& error) {
    return failed(error.what());
  }
}

PageAnswer PageAnswers::answer_text(const PageRequest& request, std::string_view path) {
  if (path == kCalibration) return calibration(request.body);
  if (path == kPrint) return make_print(request.body);
  cut_part(path);
  return live_ ? live_->post(path, request.body) : run_order(path);
}

PageAnswer PageAnswers::answer_path(const PageRequest& request, std::string_view path) {
  if (path == "fields.json") return answer_with(200, description(), "application/json");
  if (path == "page.html") return whole_page();
  for (const PageFile& file : page_files())
    if (file.name == (path.empty() ? "index.html" : path)) return file_answer(file, request.accepts_gzip);
  std::string_view rest = path;
  const std::string_view part = cut_part(rest);
  if (live_ && part == kLive) return live_->get(rest);
  if (render_ && part == kRun) return run_state(rest);
  if (prints_ && part == kPrint) return print_picture(rest);
  return picture(path);
}

/// Returns the page with all data as one file, for sharing. For a render, the file has the finished frames.
PageAnswer PageAnswers::whole_page() const {
  const auto html = [](const std::vector<std::unique_ptr<PageField>>& fields) {
    return answer_with(200, page_as_file(fields, {}), "text/html; charset=utf-8");
  };
  try {
    if (!live_ && !render_) return html(fields_);
    const std::optional<std::filesystem::path> folder = live_ ? live_->finished_render() : render_->folder();
    if (!folder) return failed("The page has no pictures to save until a render of the scene has finished.");
    std::vector<std::unique_ptr<PageField>> finished;
    finished.push_back(std::make_unique<PageField>(*folder, LightFieldHints{}, Context{}));
    return html(finished);
  } catch (const Error& error) {
    return failed(error.what());
  }
}

std::string PageAnswers::description() const {
  if (render_)
    return json_to_text({{"lippmann", version()},
                         {"fields", nlohmann::ordered_json::array({field_json(fields_.front()->facts())})},
                         {"run", render_->state_after(0)}},
                        -1);
  if (!live_) return fields_text(fields_, display_, {.prints = prints_ != nullptr});
  return json_to_text(
      {{"lippmann", version()}, {"fields", nlohmann::ordered_json::array({live_->field()})}, {"live", live_->about()}}, -1);
}

InterlaceParams PageAnswers::interlace() const {
  if (live_) return live_->interlace();
  return display_ ? display_->interlace : InterlaceParams{};
}

PageAnswer PageAnswers::calibration(const std::string& text) const {
  try {
    const PageDisplay dropped = dropped_calibration(text, interlace());
    return answer_with(200, json_to_text(page_display_json(dropped), -1), "application/json");
  } catch (const Error& error) {
    return failed(error.what());
  }
}

PageAnswer PageAnswers::make_print(const std::string& request) {
  try {
    return answer_with(200, json_to_text(prints_->make(request), -1), "application/json");
  } catch (const Error& error) {
    return failed(error.what());
  }
}

PageAnswer PageAnswers::print_picture(std::string_view path) const {
  const std::string_view kind = cut_part(path);
  const std::optional<std::size_t> id = number_in(path);
  if (!id) return unknown_path();
  const Bytes bytes = prints_->picture(kind, *id);
  if (!bytes) return prints_->is_outdated(*id) ? PageAnswer{204, "text/plain", nullptr} : unknown_path();
  return {200, bytes->starts_with("RIFF") ? "image/webp" : "image/png", bytes};
}

PageAnswer PageAnswers::run_state(std::string_view path) {
  const std::string_view kind = cut_part(path);
  const std::optional<std::size_t> known = number_in(path);
  if (kind != "state" || !known) return unknown_path();
  return answer_with(200, json_to_text(render_->state_after(*known), -1), "application/json");
}

PageAnswer PageAnswers::run_order(std::string_view order) {
  try {
    if (order == "stop")
      render_->stop();
    else if (order == "resume")
      render_->resume();
    else
      return unknown_path();
    return answer_with(200, json_to_text(render_->state_after(0), -1), "application/json");
  } catch (const Error& error) {
    return failed(error.what());
  }
}

void PageAnswers::make_first_preview() {
  if (!fields_.empty() && !render_ && !display_ && preview_view_size(fields_.front()->facts())) picture("0/preview/0");
}

/// path: FIELD/KIND/FRAME as for page_picture(), or FIELD/views/FRAME/SIGMA for the views blurred by SIGMA hundredths of a
/// pixel
PageAnswer PageAnswers::picture(std::string_view path) {
  const std::optional<std::size_t> field = number_in(cut_part(path));
  const std::string_view kind = cut_part(path);
  const std::size_t slash = path.find('/');
  const bool blurs = slash != std::string_view::npos;
  const std::optional<std::size_t> frame = number_in(path.substr(0, slash));
  const std::optional<std::size_t> crosstalk = blurs ? number_in(path.substr(slash + 1)) : 0;
  if (!field || !frame || !crosstalk || *field >= fields_.size()) return unknown_path();
  const PageField& shown = *fields_[*field];
  const bool known = kind == "views" || kind == "panel" || (kind == "depth" && shown.facts().has_depth) ||
                     (kind == "provenance" && shown.facts().has_provenance) ||
                     (kind == "preview" && preview_view_size(shown.facts()));
  const bool may_blur = kind == "views" && shown.facts().panel == PanelPicture::kOwn;
  if (blurs && (!may_blur || *crosstalk < 1 || *crosstalk > kMaxCrosstalk)) return unknown_path();
  if (!known || *frame >= shown.facts().frames.size()) return unknown_path();
  try {
    const Bytes bytes = cache_.get(fmt::format("{}/{}/{}/{}", *field, kind, *frame, *crosstalk), [&] {
      if (blurs) return encoded_picture(shown.quilt(*frame, 0.01 * static_cast<double>(*crosstalk)), kServedEffort).bytes;
      return page_picture(shown, kind, *frame, kServedEffort).bytes;
    });
    return {200, bytes->starts_with("RIFF") ? "image/webp" : "image/png", bytes};
  } catch (const Error& error) {
    return failed(error.what());
  }
}

}  // namespace lippmann
