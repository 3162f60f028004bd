// Reads 3D Gaussian splats of glTF files (KHR_gaussian_splatting).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "lippmann/scene/scene.hpp"
#include "scene/gltf/attribute.hpp"

namespace lippmann::gltf {

/// Returns whether the primitive has the extension.
bool is_splats(Value primitive);

/// Returns whether a document has primitives and all of them are splats. The document may be malformed.
bool is_of_splats_alone(const nlohmann::json& document);

/// Reads the splats of a primitive. Returns nothing, with a warning, if no splat is valid. Throws Error for missing attributes,
/// wrong types or counts, and unknown kernels and colour spaces.
std::optional<Splats> read_splats(Document& document, PrimitiveId id);

}  // namespace lippmann::gltf
