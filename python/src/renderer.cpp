// Binds rendering. Arrays of Python share the memory of a frame.
#include "lippmann/frames/renderer.hpp"

#include <algorithm>
#include <utility>

#include "archive.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "interruptible.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/image/tone.hpp"
#include "lippmann/layout/film_views.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/precompensate.hpp"
#include "lippmann/replay/rendered_panel.hpp"
#include "lippmann/scene/timeline.hpp"
#include "lippmann/trace/aovs.hpp"

namespace lippmann::python {
namespace {

struct Film {
  RenderedFrame frame;
  Optics optics;
  Encoding encoding = Encoding::kSrgb;
  Affine3f world_from_display;
  Vec3d origin{0.0};  ///< origin of world coordinates, in the coordinates of the file
};
using SharedFilm = std::shared_ptr<Film>;

std::optional<Aov> layer_named(const std::string& name) {
  const auto found = std::find(kAovNames.begin(), kAovNames.end(), name);
  return found == kAovNames.end() ? std::nullopt : std::optional(static_cast<Aov>(found - kAovNames.begin()));
}

/// Returns the picture as (y, x, 3). Copies only slanted panels, whose sub-pixels are joined to pixels.
py::array picture_of(const SharedFilm& film) {
  const Image& image = film->frame.pictures.film;
  if (sub_pixels_per_pixel(film->optics) > 1) return moved(picture_of_film(image, film->optics));
  return view_of(image.data.data(), {image.height, image.width, image.channels}, film);
}

template <class Use>
auto with_picture(const Film& film, Use use) {
  const Image& image = film.frame.pictures.film;
  return sub_pixels_per_pixel(film.optics) > 1 ? use(picture_of_film(image, film.optics)) : use(image);
}

bool is_transparent(const Film& film) { return film.frame.pictures.aovs.wants(Aov::kAlpha); }

/// Settings that turn light into a picture, as in `lippmann render`: the tone, and the crosstalk to correct, as a standard
/// deviation in pixels.
struct Development {
  Tone tone;
  std::optional<double> crosstalk_px;
  bool is_none() const { return tone.is_identity() && !crosstalk_px; }
};

/// Returns codes as `lippmann render` writes them. Codes of a transparent frame are not multiplied by alpha (straight alpha).
Image8 developed_codes(const Film& film, const Development& development) {
  const FramePictures& pictures = film.frame.pictures;
  Image light = pictures.film;
  if (is_transparent(film)) divide_by_alpha(pictures.aovs[Aov::kAlpha], light);
  apply_tone(development.tone, light);  // before sub-pixels, which see different rays, are joined to pixels
  Image picture = picture_of_film(light, film.optics);
  if (development.crosstalk_px)
    precompensate_encoded(film.optics, *development.crosstalk_px, film.encoding, "precompensate", picture);
  Image8 codes = to_codes(picture, film.encoding);
  if (is_transparent(film)) codes.alpha = alpha_codes(picture_of_layer(pictures.aovs[Aov::kAlpha], film.optics));
  return codes;
}

Image8 film_codes(const Film& film, const Development& development = {}) {
  if (is_transparent(film) || !development.is_none()) return developed_codes(film, development);
  return with_picture(film, [&](const Image& picture) { return to_codes(picture, film.encoding); });
}

std::vector<unsigned char> rgba_of(const Image8& codes) {
  std::vector<unsigned char> rgba;
  rgba.reserve(4 * codes.alpha.size());
  for (std::size_t i = 0; i < codes.alpha.size(); ++i)
    rgba.insert(rgba.end(), {codes.rgb[3 * i], codes.rgb[3 * i + 1], codes.rgb[3 * i + 2], codes.alpha[i]});
  return rgba;
}

py::array codes_of_film(const Film& film) {
  Image8 codes;
  {
    const py::gil_scoped_release release;
    codes = film_codes(film);
  }
  if (!codes.alpha.empty()) return moved(rgba_of(codes), {codes.height, codes.width, 4});
  return moved(std::move(codes.rgb), {codes.height, codes.width, 3});
}

/// Writes the picture as `lippmann render` does: linear floats to .exr, otherwise sRGB codes. `tone` has no effect on .exr.
void write(const Film& film, const std::filesystem::path& path, const Tone& tone, std::optional<double> crosstalk_px) {
  const py::gil_scoped_release release;
  if (path.extension() != ".exr") return write_picture(path, film_codes(film, {tone, crosstalk_px}));
  if (!crosstalk_px) return with_picture(film, [&](const Image& picture) { write_picture(path, picture); });
  Image picture = picture_of_film(film.frame.pictures.film, film.optics);
  precompensate_encoded(film.optics, *crosstalk_px, film.encoding, "precompensate", picture);
  write_picture(path, picture);
}

const Image& required_layer(const Film& film, const std::string& name) {
  const std::optional<Aov> aov = layer_named(name);
  if (aov && film.frame.pictures.aovs.images[static_cast<std::size_t>(*aov)].width > 0) return film.frame.pictures.aovs[*aov];
  throw Error("layers", "'" + name + "' was not rendered", "its name among `layers` when the frame is rendered");
}

/// Returns a layer as (y, x, channel), in the layout of the panel.
py::array layer_on_panel(const SharedFilm& film, const std::string& name) {
  const Image& image = required_layer(*film, name);
  if (sub_pixels_per_pixel(film->optics) > 1) return moved(picture_of_layer(image, film->optics));
  return view_of(image.data.data(), {image.height, image.width, image.channels}, film);
}

/// Returns a layer as (views, y, x, channel), with view 0 first.
py::array layer_of_views(const Film& film, const std::string& name, int views) {
  const Image& layer = required_layer(film, name);
  Image stack;
  {
    const py::gil_scoped_release release;
    stack = views_of_layer(layer, film.optics);
  }
  return moved(std::move(stack.data), {views, stack.height / views, stack.width, stack.channels});
}

/// in_world: each camera gets its pose in the world, and its depth is stored in the frame of the camera.
std::shared_ptr<LightField> views_of_film(const Film& film, bool in_world) {
  const py::gil_scoped_release release;
  const FramePictures& pictures = film.frame.pictures;
  const Image& depth = pictures.aovs[Aov::kDepth];
  auto field = std::make_shared<LightField>(light_field_of(pictures.film, film.optics, depth.width > 0 ? &depth : nullptr));
  if (in_world) place_in_world(*field, film.world_from_display, film.origin);
  return field;
}

/// Returns the picture and the optics for simulated eyes, with full parallax even if `fit_depth` reduced it.
std::shared_ptr<RenderedPanel> panel_of_film(const Film& film) {
  const py::gil_scoped_release release;
  return std::make_shared<RenderedPanel>(
      RenderedPanel{with_parallax(film.optics, 1.0f), picture_of_film(film.frame.pictures.film, film.optics)});
}

py::dict report_of(const Film& film) {
  const FrameReport& report = film.frame.report;
  py::dict figures;
  figures["frame"] = report.frame, figures["kind"] = report.kind;
  figures["seconds"] = report.seconds, figures["cpu_seconds"] = report.cpu_seconds;
  figures["rays"] = report.rays.total();
  figures["reused_pixels"] = report.reused_pixels, figures["missed_pixels"] = report.missed_pixels;
  figures["estimated_psnr_db"] = report.estimated_psnr_db;
  figures["psnr_at_least_db"] = report.psnr_at_least_db, figures["psnr_at_most_db"] = report.psnr_at_most_db;
  return figures;
}

Reuse reuse_named(const std::string& name, const std::optional<int>& keyframes, const std::optional<double>& min_psnr_db) {
  if (name == "none") return TraceAll{};
  if (name == "copy") return CopySettled{keyframes};
  if (name == "interpolate") return Interpolate{.keyframes = keyframes, .min_psnr_db = min_psnr_db};
  return AutoReuse{};
}

/// Fills in all defaults. integrator: a name of integrators(), or empty for the scene's default.
Sampling sampling_of(const Scene& scene, const std::string& integrator, bool interpolates) {
  Sampling sampling;
  for (const Integrator known : integrators())
    if (known.facts().name == integrator) sampling.integrator = known;
  return completed(std::move(sampling), scene.kind, interpolates);
}

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const Integrator known : integrators()) names.emplace_back(known.facts().name);
  return names;
}

bool denoises(const Sampling& sampling) { return sampling.denoise == Denoise::kAuto; }

void set_denoise(Sampling& sampling, bool on) { sampling.denoise = on ? Denoise::kAuto : Denoise::kNone; }

void want_layers(Sampling& sampling, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (const std::optional<Aov> aov = layer_named(name)) sampling.aov.push_back(*aov);
}

/// renderer_ is the last member, because it uses the other members.
class Frames {
 public:
  Frames(Scene& scene, Placement placement, const FrameParams& params, int threads) : work_(threads), placement_(placement) {
    work_.run(py::none(),
              [&](const Context& context) { renderer_.emplace(std::move(scene), std::move(placement), params, context); });
  }

  SharedFilm frame(int index, const py::object& progress) {
    if (!renderer_) throw_stopped();
    std::optional<RenderedFrame> made;
    try {
      work_.run(progress, [&](const Context&) { made = renderer_->frame(index); });
    } catch (...) {
      // An interrupted frame may leave the data that frames share incomplete.
      if (work_.context().cancelled) renderer_.reset();
      throw;
    }
    if (!made) throw_stopped();
    const Scene& scene = renderer_->scene();
    return std::make_shared<Film>(
        Film{std::move(*made), placement_.placed.optics, scene.encoding,
             world_from_display(placement_.array, placement_.placed.units_per_mm, evaluate(scene, scene.timeline.time(index))),
             scene.origin});
  }

  const Placement& placement() const { return placement_; }

  std::shared_ptr<Scene> scene() const {
    if (!renderer_) throw_stopped();
    return std::make_shared<Scene>(renderer_->scene());
  }

 private:
  [[noreturn]] static void throw_stopped() { throw Error("frames", "rendering was stopped", "a new call of lippmann.frames"); }

  Interruptible work_;
  Placement placement_;
  std::optional<Renderer> renderer_;
};

/// A class, because pybind11 would convert a variant to one of several Python types.
struct ChosenReuse {
  Reuse reuse;
};

std::shared_ptr<Frames> frames_of(Scene& scene, const Placement& placement, const Sampling& sampling, const ChosenReuse& reuse,
                                  int threads) {
  return std::make_shared<Frames>(scene, placement, FrameParams{sampling, reuse.reuse}, threads);
}

void bind_frame_params(py::module_& module) {
  py::class_<Sampling>(module, "Sampling")
      .def(py::init(&sampling_of))
      .def_property_readonly("is_stochastic", [](const Sampling& s) { return facts_of(s).is_stochastic; })
      .def_property_readonly("can_share_pixels", [](const Sampling& s) { return facts_of(s).can_share_pixels; })
      .def(pickled<Sampling>())
      .def("want_layers", &want_layers)
      .def_readwrite("spp", &Sampling::spp)
      .def_readwrite("max_depth", &Sampling::max_depth)
      .def_readwrite("seed", &Sampling::seed)
      .def_property("denoise", &denoises, &set_denoise)
      .def_readwrite("transparent", &Sampling::transparent)
      .def_readwrite("shutter", &Sampling::shutter)
      .def_readwrite("clamp_indirect", &Sampling::clamp_indirect)
      .def("set_angular_filter",
           [](Sampling& sampling, bool is_box) {
             sampling.angular_filter = is_box ? AngularFilter::kBox : AngularFilter::kNone;
           })
      .def("set_lens", [](Sampling& sampling, float aperture_mm, float f_number, float focal_plane_mm) {
        sampling.lens = {aperture_mm, f_number, focal_plane_mm};
      });
  py::class_<ChosenReuse>(module, "Reuse")
      .def(py::init([](const std::string& name, const std::optional<int>& keyframes, const std::optional<double>& min_psnr_db) {
        return ChosenReuse{reuse_named(name, keyframes, min_psnr_db)};
      }))
      .def(pickled<ChosenReuse>());
}

}  // namespace

void bind_renderer(py::module_& module) {
  module.def("integrator_names", &integrator_names);
  py::class_<Film, SharedFilm>(module, "Film")
      .def(pickled<Film>())
      .def_property_readonly("picture", &picture_of)
      .def_property_readonly("is_transparent", &is_transparent)
      .def_property_readonly("codes", &codes_of_film)
      .def_property_readonly("report", &report_of)
      .def_property_readonly("world_from_display", [](const Film& f) { return matrix_of(f.world_from_display, f.origin); })
      .def("write", &write)
      .def("layer", &layer_on_panel)
      .def("layer_of_views", &layer_of_views)
      .def("views", &views_of_film)
      .def("panel", &panel_of_film);

  bind_frame_params(module);
  py::class_<Frames, std::shared_ptr<Frames>>(module, "Frames")
      .def(py::init(&frames_of))
      .def("frame", &Frames::frame)
      .def_property_readonly("scene", &Frames::scene)
      .def_property_readonly("placement", &Frames::placement);

  std::vector<std::string> layers(kAovNames.begin(), kAovNames.end());
  module.attr("layer_names") = py::tuple(py::cast(layers));
}

}  // namespace lippmann::python
