// Based on: Khronos Group, "KHR_gaussian_splatting", release candidate of 2026. Scales are standard deviations. In the draft of
// 2025 they were logarithms; such files are recognised because most of their scales are negative.
#include "scene/gltf/splats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/gltf/accessor.hpp"
#include "scene/splats.hpp"

namespace lippmann::gltf {
namespace {

constexpr const char* kGaussianSplatting = "KHR_gaussian_splatting";

std::string semantic(const std::string& name) { return fmt::format("{}:{}", kGaussianSplatting, name); }

class SplatPrimitive {
 public:
  SplatPrimitive(Document& document, PrimitiveId id)
      : document_(document), id_(id), primitive_(primitive_of(document, id)), where_(element(id)) {}

  Splats read() {
    if (mode_of(primitive_) != Mode::kPoints) fail("has splats, but its mode is not POINTS", "mode 0");
    if (const std::string kernel = word("kernel"); kernel != "ellipse" && !kernel.empty())
      fail(fmt::format("its splats have the kernel {}", shown(kernel)), "ellipse");
    Splats splats;
    splats.is_linear = reads_linear();
    splats.centers = values<Vec3f>("POSITION");
    count_ = splats.centers.size();
    for (const Vec4f& q : values<Vec4f>(semantic("ROTATION"))) splats.rotations.emplace_back(q.w, q.x, q.y, q.z);
    splats.deviations = read_deviations();
    splats.opacities = values<float>(semantic("OPACITY"));
    read_harmonics(splats);
    return splats;
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& accepted = {}) const {
    document_.report.fail(where_, problem, accepted);
  }

  std::string word(const char* key) const { return primitive_.extension(kGaussianSplatting)[key].text(); }

  bool reads_linear() const {
    const std::string space = word("colorSpace");
    if (space == "lin_rec709_display") return true;
    if (space != "srgb_rec709_display" && !space.empty())
      fail(fmt::format("its splats have the colour space {}", shown(space)), "srgb_rec709_display, lin_rec709_display");
    return false;
  }

  template <class T>
  std::vector<T> values(const std::string& name) {
    const int accessor = attribute(primitive_, name);
    if (accessor < 0) fail(fmt::format("its splats have no attribute {}", name));
    const std::size_t count = document_.accessor(accessor).count;
    if (name != "POSITION" && count != count_) fail(fmt::format("has {} positions, but {} values of {}", count_, count, name));
    return unpack<T>(document_, accessor);
  }

  std::vector<Vec3f> read_deviations() {
    std::vector<Vec3f> scales = values<Vec3f>(semantic("SCALE"));
    const auto is_negative = [](Vec3f s) { return std::min({s.x, s.y, s.z}) < 0.0f; };
    const auto negative = std::count_if(scales.begin(), scales.end(), is_negative);
    if (2 * static_cast<std::size_t>(negative) <= count_) return scales;
    document_.report.warn_at("splat scales are read as logarithms because most are negative", where_);
    for (Vec3f& scale : scales) scale = glm::exp(scale);
    return scales;
  }

  static std::string harmonic(int degree, int number) { return semantic(fmt::format("SH_DEGREE_{}_COEF_{}", degree, number)); }

  void read_harmonics(Splats& splats) {
    while (splats.degree < 3 && attribute(primitive_, harmonic(splats.degree + 1, 0)) >= 0) ++splats.degree;
    const std::size_t each = harmonics_of(splats.degree);
    document_.unpacked.spend(count_, each * sizeof(Vec3f), where_, document_.report);
    splats.harmonics.resize(count_ * each);
    std::size_t k = 0;
    for (int degree = 0; degree <= splats.degree; ++degree)
      for (int number = 0; number <= 2 * degree; ++number, ++k) {
        const std::vector<Vec3f> of_all = values<Vec3f>(harmonic(degree, number));
        for (std::size_t i = 0; i < count_; ++i) splats.harmonics[i * each + k] = of_all[i];
      }
  }

  Document& document_;
  PrimitiveId id_;
  Value primitive_;
  std::string where_;
  std::size_t count_ = 0;
};

}  // namespace

bool is_splats(Value primitive) { return static_cast<bool>(primitive.extension(kGaussianSplatting)); }

std::optional<Splats> read_splats(Document& document, PrimitiveId id) {
  Splats splats = SplatPrimitive(document, id).read();
  if (drop_unsound(splats) > 0)
    document.report.warn_at("splats with a zero size or rotation, or an opacity outside 0 to 1, are left out", element(id));
  if (splats.centers.empty()) return std::nullopt;
  sort_by_place(splats);
  return splats;
}

}  // namespace lippmann::gltf
