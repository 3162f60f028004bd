// Converts the bytes of a file to a checked document:
// 1. Split the container.
// 2. Parse the JSON within limits.
// 3. Check the JSON against the schema, and remove unused properties.
// 4. Load the buffers, and read buffer views and accessors.
// 5. Decompress, and check all byte ranges. Before this step, the caller checks that the counts fit into memory (demand.hpp).
#include "scene/gltf/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "core/file_content.hpp"
#include "scene/gltf/accessor.hpp"
#include "scene/gltf/draco.hpp"
#include "scene/gltf/json.hpp"
#include "scene/gltf/meshopt.hpp"
#include "scene/gltf/resource.hpp"
#include "scene/gltf/schema.hpp"
#include "scene/texture_image.hpp"

namespace lippmann::gltf {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kExtensions[] = {
    "EXT_lights_ies",
    "EXT_lights_image_based",
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "KHR_gaussian_splatting",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "KHR_texture_transform",
};
constexpr std::string_view kSilent[] = {"KHR_xmp", "KHR_xmp_json_ld"};

struct Advice {
  std::string_view extension, text;
};
constexpr Advice kAdvice[] = {
    {"KHR_texture_basisu", kKtx2Advice},
    {"EXT_texture_avif", "convert its textures first, with gltf-transform webp IN OUT (npm's @gltf-transform/cli)"},
    {"MSFT_texture_dds", "export it again with PNG or JPEG textures"},
    {"KHR_meshopt_compression", "unpack it first, with gltfpack -i IN -o OUT -noq -kn -km -ke (npm's gltfpack)"},
    {"KHR_lights_image_based", "a draft; remove it from extensionsRequired, and pass a panorama with `environment`"},
    {"KHR_lights_area", "a draft; remove it from extensionsRequired, and replace its lamps with emissive surfaces"},
    {"KHR_animation_pointer",
     "export it again without it, or remove it from extensionsRequired; its animations are then ignored"},
    {"MSFT_lod", "remove it from extensionsRequired; the nodes are then shown in full detail"},
};
constexpr std::string_view kAnyAdvice =
    "export it again without it, or remove it from extensionsRequired; it is then ignored with a warning";

bool is_among(std::span<const std::string_view> names, const std::string& extension) {
  return std::find(names.begin(), names.end(), extension) != names.end();
}

/// This check precedes the schema check because version 1 has another schema.
void check_version(const Json& root, const Report& report) {
  const Json::json_pointer version("/asset/version"), min_version("/asset/minVersion");
  if (!root.contains(version) || !root.at(version).is_string()) report.fail("asset.version", "is missing", "2.0");
  const std::string& text = root.at(version).get_ref<const std::string&>();
  if (!text.starts_with("2.")) report.fail("asset.version", "is " + shown(text), "2.0");
  if (root.contains(min_version) && root.at(min_version) != "2.0") report.fail("asset.minVersion", "is not 2.0", "2.0");
}

std::string_view advice_on(const std::string& extension) {
  for (const Advice& advice : kAdvice)
    if (advice.extension == extension) return advice.text;
  return kAnyAdvice;
}

[[noreturn]] void refuse_extension(const std::string& name, const Report& report) {
  std::string accepted;
  for (const std::string_view known : kExtensions) accepted += fmt::format("{}{}", accepted.empty() ? "" : ", ", known);
  report.fail("extensionsRequired", fmt::format("needs {}, which is not supported: {}", printable(name), advice_on(name)),
              accepted);
}

/// Returns the list of objects that use an extension, for a message: " (materials[2] 'Silk', materials[4] and 3 more)". Returns
/// an empty text if only extensionsUsed names the extension.
std::string users_of(const ExtensionUse& use) {
  std::string text;
  for (const ExtensionUse::User& user : use.users) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", user.where);
    if (!user.name.empty()) text += fmt::format(" {}", shown(user.name));
  }
  if (use.count > use.users.size()) text += fmt::format(" and {} more", use.count - use.users.size());
  return text.empty() ? text : fmt::format(" ({})", text);
}

void check_extensions(const Json& root, UsedExtensions used, Report& report) {
  for (const Json& name : root.value("extensionsUsed", Json::array())) used[name.get<std::string>()];
  const auto is_known = [](const std::string& name) { return is_among(kExtensions, name) || is_among(kSilent, name); };
  for (const Json& name : root.value("extensionsRequired", Json::array()))
    if (const std::string& text = name.get_ref<const std::string&>(); !is_known(text)) refuse_extension(text, report);
  for (const auto& [name, use] : used)
    if (!is_known(name))
      report.warn(fmt::format("the extension {} is not supported and is ignored{}", printable(name), users_of(use)));
}

/// Returns the contents of a buffer, from a file or from embedded data. `left` is the number of bytes that buffers may still
/// load.
Bytes fetch_buffer(Value buffer, const std::string& where, std::uint64_t& left, Document& document) {
  const std::string& uri = buffer["uri"].text();
  document.loaded.push_back(fetch(uri, document.folders, left, where, document.report));
  const bool is_short = document.loaded.back().size() < buffer["byteLength"].count();
  if (const auto stand_in = stand_in_for_file(document.loaded.back()); stand_in && is_short && !uri.starts_with("data:"))
    document.report.fail(where, fmt::format("{} is {}", shown(uri), stand_in->what), stand_in->advice);
  left -= std::min<std::uint64_t>(left, document.loaded.back().size());
  return document.loaded.back();
}

void read_buffers(std::optional<Bytes> binary, Document& document) {
  const Value buffers = document.root["buffers"];
  std::uint64_t left = document.limits.file_bytes;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const Value buffer = buffers.at(i);
    const std::string where = element("buffers", i);
    if (is_fallback(buffer)) {
      document.buffers.emplace_back();
      continue;
    }
    const bool in_chunk = !buffer["uri"];
    if (in_chunk && (i != 0 || !binary)) document.report.fail(where, "has no uri, and there is no binary chunk for it");
    const Bytes available = in_chunk ? *binary : fetch_buffer(buffer, where, left, document);
    const std::size_t declared = buffer["byteLength"].count();
    if (declared > available.size())
      document.report.fail(where, fmt::format("states {} bytes, but {} are available", declared, available.size()));
    document.buffers.push_back(available.first(declared));
  }
}

BufferView read_view(Value from) {
  return {from["buffer"].index(), from["byteOffset"].count(), from["byteLength"].count(), from["byteStride"].count()};
}

Sparse read_sparse(Value from) {
  const Value indices = from["indices"], values = from["values"];
  return {.count = from["count"].count(),
          .index_view = indices["bufferView"].index(),
          .value_view = values["bufferView"].index(),
          .index_offset = indices["byteOffset"].count(),
          .value_offset = values["byteOffset"].count(),
          .index_type = static_cast<ComponentType>(indices["componentType"].integer(0))};
}

Accessor read_accessor(Value from) {
  Accessor accessor;
  accessor.buffer_view = from["bufferView"].index();
  accessor.byte_offset = from["byteOffset"].count();
  accessor.count = from["count"].count();
  accessor.component_type = static_cast<ComponentType>(from["componentType"].integer(0));
  accessor.normalized = from["normalized"].flag(false);
  const std::string& type = from["type"].text();  // SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4
  const int side = type == "SCALAR" ? 1 : type.back() - '0';
  accessor.matrix_side = type.starts_with("MAT") ? side : 0;
  accessor.components = accessor.matrix_side ? side * side : side;
  if (const Value sparse = from["sparse"]) accessor.sparse = read_sparse(sparse);
  return accessor;
}

void read_layout(Document& document) {
  const Value views = document.root["bufferViews"], accessors = document.root["accessors"];
  for (std::size_t i = 0; i < views.size(); ++i) {
    document.buffer_views.push_back(read_view(views.at(i)));
    document.packed_views.push_back(packed_view(views.at(i)));
  }
  for (std::size_t i = 0; i < accessors.size(); ++i) document.accessors.push_back(read_accessor(accessors.at(i)));
}

/// Checks the sampler index of each channel. The schema check only covers indices into the arrays of the root.
void check_channels(const Document& document) {
  const Value animations = document.root["animations"];
  for (std::size_t i = 0; i < animations.size(); ++i) {
    const Value channels = animations.at(i)["channels"];
    const std::size_t samplers = animations.at(i)["samplers"].size();
    for (std::size_t c = 0; c < channels.size(); ++c)
      if (const std::size_t sampler = channels.at(c)["sampler"].count(); sampler >= samplers)
        document.report.fail(element("animations", i, "channels", c),
                             fmt::format("refers to samplers[{}], but the number of samplers is {}", sampler, samplers));
  }
}

}  // namespace

void Budget::spend(std::uint64_t count, std::uint64_t size, std::string_view element, const Report& report) {
  if (count > left_ / size)
    report.fail(element, "the unpacked scene needs too much memory", fmt::format("at most {} bytes in total", limit_));
  left_ -= count * size;
}

void read_document(std::vector<std::byte> contents, Document& document) {
  document.contents = std::move(contents);
  const Container container = split_container(document.contents, document.report);
  Json root = parse_json(container.json, document.limits, document.report);
  check_version(root, document.report);
  SchemaFindings findings = check_schema(root, document.report);
  findings.unknown.warn(document.report.context(), "property", "properties");
  check_extensions(root, std::move(findings.extensions), document.report);
  document.json = std::make_shared<const Json>(std::move(root));
  document.root = Value(*document.json);
  check_channels(document);
  read_buffers(container.binary, document);
  read_layout(document);
  check_packed_views(document);
}

void unpack_document(Document& document) {
  unpack_views(document);
  check_views(document);
  unpack_primitives(document);
  check_accessors(document);
}

Bytes Document::view(int index) const {
  const BufferView& view = buffer_views[static_cast<std::size_t>(index)];
  return buffers[static_cast<std::size_t>(view.buffer)].subspan(view.byte_offset, view.byte_length);
}

std::string image_problem(const Document& document, std::size_t image) {
  const Value source = document.root["images"].at(image);
  const std::string& uri = source["uri"].text();
  if (source["bufferView"] || uri.empty()) return {};
  return uri_problem(uri, document.folders, document.report.where(element("images", image)));
}

Bytes image_bytes(const Document& document, std::size_t image, std::vector<std::byte>& storage) {
  const Value source = document.root["images"].at(image);
  if (const Value view = source["bufferView"]) return document.view(view.index());
  const std::string where = element("images", image);
  const std::string& uri = source["uri"].text();
  if (uri.empty()) document.report.fail(where, "has neither a uri nor a buffer view");
  storage = fetch(uri, document.folders, document.limits.file_bytes, where, document.report);
  return storage;
}

}  // namespace lippmann::gltf
