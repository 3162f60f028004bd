// Splats (3D Gaussians) of glTF files: KHR_gaussian_splatting.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/attribute.hpp"

namespace lippmann::gltf {

/// Whether the primitive has the extension.
bool is_splats(Value primitive);

/// Whether all primitives of a document, which may be malformed, are splats, and there are some.
bool is_of_splats_alone(const nlohmann::json& document);

/// The splats of such a primitive. None, with a warning, where none of them can be shown. Throws Error for attributes that are
/// missing or of the wrong type or number, and for kernels and colour spaces that are not known.
std::optional<Splats> read_splats(Document& document, PrimitiveId id);

}  // namespace lippmann::gltf
