#include "scene/side_textures.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "core/printable.hpp"
#include "scene/text_file.hpp"
#include "scene/texture_image.hpp"

namespace lippmann {
namespace {

FileBytes side_picture(const std::filesystem::path& file, const std::string& where, std::vector<std::byte>& storage) {
  constexpr std::size_t kLargestPicture = std::size_t{256} << 20;
  const std::string text = read_text_file(file, where, kLargestPicture, "at most 256 MiB for a picture");
  const FileBytes bytes = std::as_bytes(std::span(text));
  storage.assign(bytes.begin(), bytes.end());
  return storage;
}

}  // namespace

SideTextures::SideTextures(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context)
    : folders_(std::move(folders)), scene_(scene), context_(context), pending_({.bytes = texture_bytes}) {}

int SideTextures::add(const std::string& name, const std::string& where) {
  const auto [known, is_new] = known_.try_emplace(name, -1);
  if (!is_new) return known->second;
  const SideFile file = find_side_file(folders_, name, where);
  if (!file.problem.empty()) {
    context_.warning(fmt::format("{}: {}; the surface is shown without it.", where, file.problem));
    return -1;
  }
  const auto read = [file, where](std::vector<std::byte>& storage) { return side_picture(file.path, where, storage); };
  std::vector<std::byte> storage;
  if (const std::string problem = texture_image_problem(read(storage)); !problem.empty()) {
    context_.warning(fmt::format("{}: {} {}; the surface is shown without it.", where, shown(name), problem));
    return -1;
  }
  Texture described;
  described.name = name;
  known->second = pending_.add(std::move(described), where, read, scene_.textures);
  return known->second;
}

void SideTextures::decode() {
  pending_.decode(scene_.textures, context_, [this](const std::string& text) { context_.warning(text + "."); });
}

}  // namespace lippmann
