#include "formats/picture_alpha.hpp"

#include <array>
#include <utility>

#include "image/exr.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {

void write_picture(const std::filesystem::path& path, Picture picture, const Image* alpha) {
  if (!alpha) return write_picture(path, picture);
  check_picture_ending(path, picture);
  if (const auto* light = std::get_if<Image>(&picture)) {
    const std::array<ExrLayer, 2> layers{film_layer(*light, ExrSample::kFloat), alpha_layer(*alpha, ExrSample::kFloat)};
    return write_exr(path, layers);
  }
  if (auto* bytes = std::get_if<Image8>(&picture))
    bytes->alpha = alpha_codes(*alpha);
  else
    std::get<Image16>(picture).alpha = alpha_codes16(*alpha);
  write_picture(path, picture);
}

}  // namespace lippmann
