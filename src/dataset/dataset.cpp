#include "lippmann/dataset/dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <numeric>
#include <span>
#include <system_error>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/file_checksum.hpp"
#include "core/folder.hpp"
#include "core/json_text.hpp"
#include "core/npy.hpp"
#include "core/regular_file.hpp"
#include "dataset/dataset_scene.hpp"
#include "distribute/units.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/version.hpp"
#include "lippmann/frames/renderer.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/layout/film_views.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxJsonBytes = std::uintmax_t{16} << 20;
constexpr int kShownFrame = 1;

void check_dataset(const DatasetParams& params) {
  constexpr int kMostSamples = 1'000'000;
  if (params.count < 1 || params.count > kMostSamples)
    throw usage_error("count", fmt::format("cannot be {}", params.count), fmt::format("1 to {}", kMostSamples));
  if (params.view_size.x < 8 || params.view_size.y < 8)
    throw usage_error("size", fmt::format("cannot be {}x{}", params.view_size.x, params.view_size.y), "8x8 or more");
}

std::string sample_name(int index) { return fmt::format("sample_{:06}", index); }

Json description(const DatasetParams& params) {
  return {{"version", version()},
          {"scenes", params.scenes},
          {"count", params.count},
          {"seed", params.seed},
          {"views", {params.grid.columns, params.grid.rows}},
          {"size", {params.view_size.x, params.view_size.y}},
          {"spp", params.spp}};
}

void write_json(const fs::path& path, const Json& json) {
  const std::string text = json_to_text(json) + "\n";
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

std::optional<Json> read_optional_json(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::nullopt;
  return json_from_text(read_file_text(path, kMaxJsonBytes));
}

void claim_dataset_folder(const DatasetParams& params) {
  make_folder(params.folder);
  const fs::path path = params.folder / "dataset.json";
  const Json wanted = description(params);
  const std::optional<Json> there = read_optional_json(path);
  if (there && *there != wanted)
    throw Error(params.folder.string(), "holds a data set that was made with other parameters or another version",
                "another folder, or the parameters in its dataset.json");
  if (!there) write_json(path, wanted);
}

/// Returns the sample.json of a sample, or nullopt if it is damaged, or if a file is missing or does not have its recorded
/// size.
std::optional<Json> complete_sample(const fs::path& folder) try {
  std::optional<Json> json = read_optional_json(folder / "sample.json");
  if (!json || !json->is_object() || !json->contains("files") || !(*json)["files"].is_array()) return std::nullopt;
  for (const Json& file : (*json)["files"]) {
    if (!file.is_object() || !file.contains("name") || !file["name"].is_string() || !file.contains("bytes"))
      return std::nullopt;
    std::error_code missing;
    const std::uintmax_t bytes = fs::file_size(folder / file["name"].get<std::string>(), missing);
    if (missing || file["bytes"] != bytes) return std::nullopt;
  }
  return json;
} catch (const Error&) {
  return std::nullopt;
}

enum class SampleState { kMissing, kDamaged, kIntact };

/// Reads every file of the sample once, to compare its checksum.
SampleState sample_state(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return SampleState::kMissing;
  const std::optional<Json> sample = complete_sample(folder);
  if (!sample) return SampleState::kDamaged;
  for (const Json& file : (*sample)["files"]) {
    const std::optional<FileChecksum> sum = file_checksum(folder / file["name"].get<std::string>());
    if (!sum || !file.contains("xxh3") || file["xxh3"] != sum->xxh3) return SampleState::kDamaged;
  }
  return SampleState::kIntact;
}

class SampleFiles {
 public:
  SampleFiles(fs::path folder, int views, Vec2i size)
      : folder_(std::move(folder)),
        shape_{static_cast<std::size_t>(views), static_cast<std::size_t>(size.y), static_cast<std::size_t>(size.x)} {}

  /// Writes one array with the pixels of all views, with one or more values per pixel.
  template <class Sample>
  void add(const std::string& name, const std::vector<Sample>& samples) {
    std::vector<std::size_t> shape = shape_;
    const std::size_t pixels = shape_[0] * shape_[1] * shape_[2];
    if (samples.size() > pixels) shape.push_back(samples.size() / pixels);
    const std::vector<std::byte> file = encode_npy(std::span<const Sample>(samples), shape);
    write_file_atomically(folder_ / name, file);
    const FileChecksum sum = checksum_of(file);
    files_.push_back({{"name", name}, {"bytes", sum.bytes}, {"xxh3", sum.xxh3}});
    bytes_ += sum.bytes;
  }

  const Json& files() const { return files_; }
  std::uint64_t bytes() const { return bytes_; }

 private:
  fs::path folder_;
  std::vector<std::size_t> shape_;
  Json files_ = Json::array();
  std::uint64_t bytes_ = 0;
};

/// Returns the disparity of each pixel: how many pixels the point shifts to the left from a view to the next on the right. The
/// background has the disparity -infinity.
std::vector<float> disparities(const std::vector<float>& depth_mm, const DatasetCameras& cameras) {
  std::vector<float> disparity;
  disparity.reserve(depth_mm.size());
  for (const float z : depth_mm)
    disparity.push_back(z == -kInfinity ? z : cameras.baseline_mm * z / ((cameras.distance_mm - z) * cameras.pixel_mm));
  return disparity;
}

Json sample_json(const DatasetParams& params, int index, const DatasetCameras& cameras, const Json& files) {
  return {{"index", index},
          {"seed", params.seed},
          {"cameras",
           {{"views", {params.grid.columns, params.grid.rows}},
            {"distance_mm", cameras.distance_mm},
            {"baseline_mm", cameras.baseline_mm},
            {"pixel_mm", cameras.pixel_mm}}},
          {"files", files}};
}

std::optional<std::uint64_t> make_sample(const DatasetParams& params, const std::vector<Mesh>& meshes, int index,
                                         const Context& context) {
  SampleRandom random(params.seed, static_cast<std::uint32_t>(index));
  const DatasetCameras cameras = dataset_cameras(params.grid, params.view_size, random);
  const Optics& optics = cameras.optics;
  Scene scene = dataset_scene(meshes, random);
  const Placement placement = place(scene, optics);
  FrameParams frame_params;
  frame_params.sampling = {.integrator = Integrator::kPath, .spp = params.spp, .seed = params.seed};
  frame_params.sampling.aov = {Aov::kDepth, Aov::kNormal, Aov::kId, Aov::kMotion};
  frame_params.reuse = TraceAll{};
  Renderer renderer(std::move(scene), placement, frame_params, context);
  const std::optional<RenderedFrame> frame = renderer.frame(kShownFrame);
  if (!frame) return std::nullopt;
  const FrameAovs& aovs = frame->pictures.aovs;
  const fs::path folder = params.folder / sample_name(index),
                 part = params.folder / fmt::format(".{}.part", sample_name(index));
  fs::remove_all(part);
  make_folder(part);
  SampleFiles files(part, params.grid.count(), params.view_size);
  const LightField field = light_field_of(frame->pictures.film, optics);
  files.add("views.npy", to_codes(std::get<Image>(field.stack), Encoding::kSrgb).rgb);
  const Image depth = views_of_layer(aovs[Aov::kDepth], optics);
  files.add("depth.npy", depth.data);
  files.add("disparity.npy", disparities(depth.data, cameras));
  files.add("normal.npy", views_of_layer(aovs[Aov::kNormal], optics).data);
  files.add("motion.npy", views_of_layer(aovs[Aov::kMotion], optics).data);
  const std::vector<float> ids = views_of_layer(aovs[Aov::kId], optics).data;
  files.add("id.npy", std::vector<std::int16_t>(ids.begin(), ids.end()));
  write_json(part / "sample.json", sample_json(params, index, cameras, files.files()));
  fs::remove_all(folder);
  fs::rename(part, folder);
  return files.bytes();
}

std::vector<int> samples_of(const DatasetParams& params) {
  std::vector<int> all(static_cast<std::size_t>(params.count));
  std::iota(all.begin(), all.end(), 0);
  return params.unit.empty() ? all : frames_of(read_units(params.unit, "unit"), all, 1);
}

bool write_manifest(const DatasetParams& params) {
  Json samples = Json::array();
  for (int index = 0; index < params.count; ++index) {
    std::optional<Json> sample = complete_sample(params.folder / sample_name(index));
    if (!sample) return false;
    samples.push_back(std::move(*sample));
  }
  Json manifest = description(params);
  manifest["samples"] = std::move(samples);
  write_json(params.folder / "manifest.json", manifest);
  return true;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

DatasetReport make_dataset(const DatasetParams& params, const Context& context, const DatasetObserver& observer) {
  check_dataset(params);
  const std::vector<int> samples = samples_of(params);
  std::vector<Mesh> meshes;
  for (const std::string& name : params.scenes)
    for (Mesh& mesh : unit_meshes_of(load_scene(name, {}, context))) meshes.push_back(std::move(mesh));
  claim_dataset_folder(params);
  DatasetReport report{.wanted = static_cast<int>(samples.size())};
  struct Planned {
    int index;
    bool is_damaged;
  };
  std::vector<Planned> planned;
  for (const int index : samples) {
    if (context.cancelled) return report;
    const SampleState state = sample_state(params.folder / sample_name(index));
    if (state == SampleState::kIntact)
      ++report.kept;
    else
      planned.push_back({index, state == SampleState::kDamaged});
  }
  if (observer.planned) observer.planned(static_cast<int>(planned.size()), report.kept);
  for (const auto& [index, is_damaged] : planned) {
    const auto start = std::chrono::steady_clock::now();
    const std::optional<std::uint64_t> bytes = make_sample(params, meshes, index, context);
    if (!bytes || context.cancelled) return report;
    const double seconds = seconds_since(start);
    ++report.made, report.seconds += seconds, report.bytes += *bytes;
    if (is_damaged) ++report.remade;
    if (observer.made) observer.made(index, seconds);
  }
  report.is_complete = write_manifest(params);
  return report;
}

}  // namespace lippmann
