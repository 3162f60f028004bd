#include "image/icc_transform.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

#if LIPPMANN_HAS_LCMS
#include <lcms2.h>
#endif

namespace lippmann {

#if LIPPMANN_HAS_LCMS
namespace {

struct ContextDeleter {
  void operator()(cmsContext context) const { cmsDeleteContext(context); }
};
struct ProfileDeleter {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
struct TransformDeleter {
  void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using IccContext = std::unique_ptr<std::remove_pointer_t<cmsContext>, ContextDeleter>;
using OpenProfile = std::unique_ptr<void, ProfileDeleter>;
using OpenTransform = std::unique_ptr<void, TransformDeleter>;

OpenProfile output_profile(cmsContext context, cmsColorSpaceSignature space) {
  OpenProfile srgb(cmsCreate_sRGBProfileTHR(context));
  if (!srgb || space != cmsSigGrayData) return srgb;
  const auto* curve = static_cast<const cmsToneCurve*>(cmsReadTag(srgb.get(), cmsSigRedTRCTag));
  return OpenProfile(curve ? cmsCreateGrayProfileTHR(context, cmsD50_xyY(), curve) : nullptr);
}

OpenProfile open_profile(cmsContext context, FileBytes icc) {
  if (icc.size() > std::numeric_limits<cmsUInt32Number>::max()) return nullptr;
  return OpenProfile(cmsOpenProfileFromMemTHR(context, icc.data(), static_cast<cmsUInt32Number>(icc.size())));
}

/// Returns a transform to sRGB, or null if the profile is not for the colour space `space`. The transform copies `extra`
/// channels that follow the colours. `bytes` is the size of a sample.
OpenTransform transform_of(cmsContext context, FileBytes icc, cmsColorSpaceSignature space, unsigned extra, unsigned bytes) {
  const OpenProfile from = open_profile(context, icc);
  if (!from || cmsGetColorSpace(from.get()) != space) return nullptr;
  const OpenProfile to = output_profile(context, space);
  if (!to) return nullptr;
  const bool is_cmyk = space == cmsSigCmykData, is_grey = space == cmsSigGrayData;
  const cmsUInt32Number layout = EXTRA_SH(extra) | BYTES_SH(bytes);
  const cmsUInt32Number rgb = COLORSPACE_SH(PT_RGB) | CHANNELS_SH(3) | layout,
                        grey = COLORSPACE_SH(PT_GRAY) | CHANNELS_SH(1) | layout,
                        cmyk = COLORSPACE_SH(PT_CMYK) | CHANNELS_SH(4) | layout;
  const cmsUInt32Number flags = cmsFLAGS_BLACKPOINTCOMPENSATION | cmsFLAGS_NOCACHE | (extra > 0 ? cmsFLAGS_COPY_ALPHA : 0);
  return OpenTransform(cmsCreateTransformTHR(context, from.get(), is_cmyk ? cmyk : (is_grey ? grey : rgb), to.get(),
                                             is_grey ? grey : rgb, INTENT_RELATIVE_COLORIMETRIC, flags));
}

/// Converts this many pixels at once, because Little CMS counts pixels with 32 bits.
constexpr std::size_t kPixelsAtOnce = std::size_t{1} << 20;

template <class Code>
void apply_transform(void* with, const std::vector<Code>& from, std::size_t from_channels, std::vector<Code>& to,
                     std::size_t to_channels) {
  const std::size_t pixels = from.size() / from_channels;
  for (std::size_t at = 0; at < pixels; at += kPixelsAtOnce)
    cmsDoTransform(with, from.data() + at * from_channels, to.data() + at * to_channels,
                   static_cast<cmsUInt32Number>(std::min(kPixelsAtOnce, pixels - at)));
}

bool has_inks(cmsHPROFILE profile) { return cmsGetColorSpace(profile) == cmsSigCmykData; }

/// Returns a transform from sRGB, or null if the profile is neither RGB nor CMYK.
OpenTransform output_transform(cmsContext context, cmsHPROFILE to, std::size_t bytes) {
  if (!has_inks(to) && cmsGetColorSpace(to) != cmsSigRgbData) return nullptr;
  const OpenProfile from(cmsCreate_sRGBProfileTHR(context));
  const cmsUInt32Number rgb = COLORSPACE_SH(PT_RGB) | CHANNELS_SH(3) | BYTES_SH(bytes),
                        cmyk = COLORSPACE_SH(PT_CMYK) | CHANNELS_SH(4) | BYTES_SH(bytes);
  return OpenTransform(cmsCreateTransformTHR(context, from.get(), rgb, to, has_inks(to) ? cmyk : rgb,
                                             INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_BLACKPOINTCOMPENSATION | cmsFLAGS_NOCACHE));
}

}  // namespace

std::optional<int> output_channels(FileBytes icc) {
  const IccContext context(cmsCreateContext(nullptr, nullptr));
  const OpenProfile profile = open_profile(context.get(), icc);
  if (!profile || !output_transform(context.get(), profile.get(), 1)) return std::nullopt;
  return has_inks(profile.get()) ? 4 : 3;
}

std::optional<Samples> output_codes(FileBytes icc, const Samples& rgb) {
  const IccContext context(cmsCreateContext(nullptr, nullptr));
  const OpenProfile to = open_profile(context.get(), icc);
  if (!to) return std::nullopt;
  const std::size_t channels = has_inks(to.get()) ? 4 : 3;
  return std::visit(
      [&](const auto& codes) -> std::optional<Samples> {
        using Code = typename std::remove_cvref_t<decltype(codes)>::value_type;
        if constexpr (std::is_floating_point_v<Code>) return std::nullopt;
        const OpenTransform with = output_transform(context.get(), to.get(), sizeof(Code));
        if (!with) return std::nullopt;
        std::vector<Code> printed(codes.size() / 3 * channels);
        apply_transform(with.get(), codes, 3, printed, channels);
        return Samples(std::move(printed));
      },
      rgb);
}

bool apply_color_profile(FileBytes icc, const PictureHeader& header, Samples& samples) {
  constexpr std::size_t kMaxExtraChannels = 7;  // highest number of extra channels of Little CMS
  const std::size_t channels = header.channels.size(), colors = static_cast<std::size_t>(header.colors);
  if ((colors != 1 && colors != 3) || channels - colors > kMaxExtraChannels) return false;
  const IccContext context(cmsCreateContext(nullptr, nullptr));
  return std::visit(
      [&](auto& codes) {
        using Code = typename std::remove_cvref_t<decltype(codes)>::value_type;
        if constexpr (std::is_floating_point_v<Code>) return false;
        const OpenTransform with = transform_of(context.get(), icc, colors == 1 ? cmsSigGrayData : cmsSigRgbData,
                                                static_cast<unsigned>(channels - colors), sizeof(Code));
        if (!with) return false;
        apply_transform(with.get(), codes, channels, codes, channels);
        return true;
      },
      samples);
}

std::optional<Samples> rgb_of_inks(FileBytes icc, const Samples& inks) {
  constexpr std::size_t kInks = 4;
  const IccContext context(cmsCreateContext(nullptr, nullptr));
  return std::visit(
      [&](const auto& codes) -> std::optional<Samples> {
        using Code = typename std::remove_cvref_t<decltype(codes)>::value_type;
        if constexpr (std::is_floating_point_v<Code>) return std::nullopt;
        const OpenTransform with = transform_of(context.get(), icc, cmsSigCmykData, 0, sizeof(Code));
        if (!with) return std::nullopt;
        std::vector<Code> rgb(codes.size() / kInks * 3);
        apply_transform(with.get(), codes, kInks, rgb, 3);
        return Samples(std::move(rgb));
      },
      inks);
}

#else

bool apply_color_profile(FileBytes, const PictureHeader&, Samples&) { return false; }

std::optional<Samples> rgb_of_inks(FileBytes, const Samples&) { return std::nullopt; }

std::optional<int> output_channels(FileBytes) { return std::nullopt; }

std::optional<Samples> output_codes(FileBytes, const Samples&) { return std::nullopt; }

#endif

}  // namespace lippmann
