#include "lippmann/image/tone.hpp"

#include <cmath>

namespace lippmann {
namespace {

Vec3f neutral(Vec3f color) {
  constexpr float kStart = 0.8f - 0.04f, kDesaturation = 0.15f;
  const float least = std::min({color.x, color.y, color.z});
  // Subtracts the 4 % Fresnel reflection that a white environment adds to the colour of a surface.
  color -= Vec3f(least < 0.08f ? least - 6.25f * least * least : 0.04f);
  const float peak = std::max({color.x, color.y, color.z});
  if (peak < kStart) return color;
  constexpr float kRange = 1.0f - kStart;
  const float new_peak = 1.0f - kRange * kRange / (peak + kRange - kStart);
  const float faded = 1.0f - 1.0f / (kDesaturation * (peak - new_peak) + 1.0f);
  return glm::mix(color * (new_peak / peak), Vec3f(new_peak), faded);
}

Vec3f agx(Vec3f color) {
  const Mat3f inset(0.842479062253094f, 0.0423282422610123f, 0.0423756549057051f,  //
                    0.0784335999999992f, 0.878468636469772f, 0.0784336f,           //
                    0.0792237451477643f, 0.0791661274605434f, 0.879142973793104f);
  const Mat3f outset(1.19687900512017f, -0.0528968517574562f, -0.0529716355144438f,  //
                     -0.0980208811401368f, 1.15190312990417f, -0.0980434501171241f,  //
                     -0.0990297440797205f, -0.0989611768448433f, 1.15107367264116f);
  constexpr float kDarkest = -12.47393f, kBrightest = 4.026069f;  // log2 of the darkest and brightest mapped value
  Vec3f x = inset * color;
  for (int c = 0; c < 3; ++c) {
    const float stops = std::clamp(std::log2(std::max(x[c], 1e-10f)), kDarkest, kBrightest);
    const float t = (stops - kDarkest) / (kBrightest - kDarkest), t2 = t * t, t4 = t2 * t2;
    x[c] = 15.5f * t4 * t2 - 40.14f * t4 * t + 31.96f * t4 - 6.868f * t2 * t + 0.4298f * t2 + 0.1191f * t - 0.00232f;
  }
  x = outset * x;
  for (int c = 0; c < 3; ++c) x[c] = std::pow(std::clamp(x[c], 0.0f, 1.0f), 2.2f);  // AgX gives codes of gamma 2.2
  return x;
}

}  // namespace

Vec3f apply_tone(const Tone& tone, Vec3f color) {
  color *= std::exp2(tone.exposure_ev);
  if (tone.curve == ToneCurve::kNone) return color;
  color = glm::max(color, Vec3f(0.0f));
  return tone.curve == ToneCurve::kNeutral ? neutral(color) : agx(color);
}

void apply_tone(const Tone& tone, Image& film) {
  if (tone.is_identity()) return;
  for (std::size_t i = 0; i + 2 < film.data.size(); i += 3) {
    const Vec3f color = apply_tone(tone, {film.data[i], film.data[i + 1], film.data[i + 2]});
    film.data[i] = color.x, film.data[i + 1] = color.y, film.data[i + 2] = color.z;
  }
}

}  // namespace lippmann
