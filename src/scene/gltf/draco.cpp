// Based on: Khronos Group, "KHR_draco_mesh_compression", 2018; Google, "Draco Bitstream Specification" 2.2, 2019, sections
// "DecodeSequentialConnectivityData" and "ParseEdgebreakerConnectivityData", which define where the counts are stored.
//
// Draco allocates as much memory as the counts in the stream require, so we check the counts first.
#include "scene/gltf/draco.hpp"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <memory>

#include "lippmann/core/error.hpp"
#include "scene/gltf/attribute.hpp"

namespace lippmann::gltf {
namespace {

/// Callbacks that check the counts of the stream before the decoder allocates memory. They throw Error if a count exceeds its
/// limit.
struct Allowance {
  std::function<void(std::uint64_t faces, std::uint64_t points)> connectivity;
  std::function<void(std::uint64_t bytes)> attributes;
};

template <class Decoder>
class CarefulDecoder final : public Decoder {
 public:
  explicit CarefulDecoder(const Allowance& allowance) : allowance_(allowance) {}

 protected:
  bool DecodeConnectivity() override {
    constexpr bool sequential = std::is_same_v<Decoder, draco::MeshSequentialDecoder>;
    // KHR_draco_mesh_compression requires this version.
    if (this->bitstream_version() != DRACO_BITSTREAM_VERSION(2, 2)) return false;
    draco::DecoderBuffer ahead = *this->buffer();
    std::uint32_t first = 0, second = 0;
    if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead)) return false;
    allowance_.connectivity(sequential ? first : second, sequential ? second : first);
    return Decoder::DecodeConnectivity();
  }

  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    std::uint64_t bytes_a_point = 0;
    for (int i = 0; i < cloud.num_attributes(); ++i)  // the decoder also needs 4 bytes per component for intermediate integers
      bytes_a_point += std::max<std::uint64_t>(static_cast<std::uint64_t>(cloud.attribute(i)->byte_stride()),
                                               4ull * static_cast<std::uint64_t>(cloud.attribute(i)->num_components()));
    allowance_.attributes(bytes_a_point * cloud.num_points());
    return Decoder::DecodeAllAttributes();
  }

 private:
  const Allowance& allowance_;
};

draco::Status decode_with(draco::MeshDecoder& decoder, draco::DecoderBuffer& stream, draco::Mesh& mesh) {
  return decoder.Decode(draco::DecoderOptions(), &stream, &mesh);
}

draco::Status decode(Bytes packed, const Allowance& allowance, draco::Mesh& mesh) {
  draco::DecoderBuffer stream, ahead;
  stream.Init(reinterpret_cast<const char*>(packed.data()), packed.size());
  ahead = stream;
  draco::DracoHeader header;
  if (const draco::Status status = draco::PointCloudDecoder::DecodeHeader(&ahead, &header); !status.ok()) return status;
  if (header.encoder_type != draco::TRIANGULAR_MESH) return draco::Status(draco::Status::DRACO_ERROR, "Not a mesh");
  if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING) {
    CarefulDecoder<draco::MeshSequentialDecoder> decoder(allowance);
    return decode_with(decoder, stream, mesh);
  }
  CarefulDecoder<draco::MeshEdgebreakerDecoder> decoder(allowance);
  return decode_with(decoder, stream, mesh);
}

/// Writes the elements of an attribute to `out`. Returns false if a value cannot be converted.
template <class T>
bool write_values(const draco::PointAttribute& attribute, int components, std::vector<std::byte>& out) {
  const std::size_t size = static_cast<std::size_t>(components) * sizeof(T), count = out.size() / size;
  std::vector<T> values(static_cast<std::size_t>(components));
  for (std::size_t i = 0; i < count; ++i) {
    const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
    if (!attribute.ConvertValue<T>(value, static_cast<int8_t>(components), values.data())) return false;
    std::memcpy(out.data() + i * size, values.data(), size);
  }
  return true;
}

template <class T>
bool write_indices(const draco::Mesh& mesh, std::vector<std::byte>& out) {
  std::size_t at = 0;
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (int k = 0; k < 3; ++k, at += sizeof(T)) {
      const std::uint32_t point = mesh.face(f)[static_cast<std::size_t>(k)].value();
      if (point > std::numeric_limits<T>::max()) return false;
      const T index = static_cast<T>(point);
      std::memcpy(out.data() + at, &index, sizeof index);
    }
  return true;
}

class PrimitiveUnpacker {
 public:
  explicit PrimitiveUnpacker(Document& document) : document_(document), report_(document.report) {}

  void unpack(PrimitiveId id, Value extension) {
    const Value primitive = primitive_of(document_, id);
    const std::string where = element(id);
    const int indices = primitive["indices"].index();
    if (mode_of(primitive) != Mode::kTriangles || indices < 0)
      report_.fail(where, "is compressed by Draco, but is not an indexed triangle list");
    const int view = extension["bufferView"].index();
    const int position = attribute(primitive, "POSITION");
    const std::uint64_t faces = accessor_at(indices).count / 3;
    const std::uint64_t points = position < 0 ? 0 : accessor_at(position).count;
    const draco::Mesh& mesh = mesh_of(view, faces, points, where);
    if (begin(indices, view, -1, 3ull * mesh.num_faces(), where)) fill_indices(indices, mesh, where);
    for (const auto& [name, unique_id] : extension["attributes"].index_map()) {
      const int accessor = attribute(primitive, name);
      if (accessor < 0) report_.fail(where, "lacks the attribute " + shown(name) + ", which is in the Draco data");
      if (!begin(accessor, view, unique_id, mesh.num_points(), where)) continue;
      const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(unique_id));
      if (!from) report_.fail(where, fmt::format("the Draco data has no attribute {}", unique_id));
      fill_values(accessor, *from, where);
    }
  }

 private:
  Accessor& accessor_at(int index) { return document_.accessors[static_cast<std::size_t>(index)]; }

  /// Returns the mesh of a buffer view, decoded on first use. Throws Error if it has more faces or points than allowed.
  const draco::Mesh& mesh_of(int view, std::uint64_t most_faces, std::uint64_t most_points, const std::string& where) {
    std::unique_ptr<draco::Mesh>& mesh = meshes_[view];
    if (mesh) return *mesh;
    mesh = std::make_unique<draco::Mesh>();
    const Allowance allowance{[&](std::uint64_t faces, std::uint64_t points) {
                                if (faces > most_faces || points > most_points)
                                  report_.fail(where, fmt::format("the Draco data has {} triangles and {} vertices, but the "
                                                                  "accessors have {} and {}",
                                                                  faces, points, most_faces, most_points));
                                document_.unpacked.spend(faces + points, kDracoTableBytes, where, report_);
                              },
                              [&](std::uint64_t bytes) { document_.unpacked.spend(bytes, 2, where, report_); }};
    std::string problem;
    try {
      const draco::Status status = decode(document_.view(view), allowance, *mesh);
      if (!status.ok()) problem = status.error_msg_string();
    } catch (const Error&) {
      throw;
    } catch (const std::exception& error) {
      problem = error.what();
    }
    if (!problem.empty()) report_.fail(where, "cannot decode the Draco data: " + printable(problem));
    return *mesh;
  }

  /// Returns whether the accessor still has to be filled from the given buffer view and attribute. Throws Error if the accessor
  /// does not have `count` elements, or if it was filled from other data.
  bool begin(int accessor, int view, int unique_id, std::uint64_t count, const std::string& where) {
    const auto [known, is_new] = filled_.try_emplace(accessor, std::pair(view, unique_id));
    if (!is_new && known->second == std::pair(view, unique_id)) return false;
    const std::string name = element("accessors", static_cast<std::size_t>(accessor));
    if (!is_new) report_.fail(where, name + " is unpacked twice, from different Draco data");
    if (accessor_at(accessor).count != count)
      report_.fail(
          where, fmt::format("the Draco data has {} elements for {}, which has {}", count, name, accessor_at(accessor).count));
    return true;
  }

  std::vector<std::byte>& new_bytes(int index, std::size_t element_size, const std::string& where) {
    Accessor& accessor = accessor_at(index);
    document_.unpacked.spend(accessor.count, element_size, where, report_);
    std::vector<std::byte>& bytes = document_.loaded.emplace_back(accessor.count * element_size);
    accessor.buffer_view = static_cast<int>(document_.buffer_views.size());
    accessor.byte_offset = 0;
    document_.buffer_views.push_back({.buffer = static_cast<int>(document_.buffers.size()), .byte_length = bytes.size()});
    document_.buffers.push_back(bytes);
    return bytes;
  }

  void fill_indices(int index, const draco::Mesh& mesh, const std::string& where) {
    const ComponentType type = accessor_at(index).component_type;
    bool good = accessor_at(index).components == 1;
    if (type == ComponentType::kUnsignedByte)
      good = good && write_indices<std::uint8_t>(mesh, new_bytes(index, 1, where));
    else if (type == ComponentType::kUnsignedShort)
      good = good && write_indices<std::uint16_t>(mesh, new_bytes(index, 2, where));
    else
      good = good && type == ComponentType::kUnsignedInt && write_indices<std::uint32_t>(mesh, new_bytes(index, 4, where));
    if (!good) report_.fail(where, "the Draco data's indices do not fit their accessor");
  }

  void fill_values(int index, const draco::PointAttribute& from, const std::string& where) {
    const int components = accessor_at(index).components;
    bool good = components >= 1 && components <= 4 && components == from.num_components();
    const auto write = [&]<class T>(T) {
      good =
          good && write_values<T>(from, components, new_bytes(index, static_cast<std::size_t>(components) * sizeof(T), where));
    };
    switch (accessor_at(index).component_type) {
      case ComponentType::kByte:
        write(std::int8_t{});
        break;
      case ComponentType::kUnsignedByte:
        write(std::uint8_t{});
        break;
      case ComponentType::kShort:
        write(std::int16_t{});
        break;
      case ComponentType::kUnsignedShort:
        write(std::uint16_t{});
        break;
      case ComponentType::kUnsignedInt:
        write(std::uint32_t{});
        break;
      case ComponentType::kFloat:
        write(float{});
        break;
      default:
        good = false;
    }
    if (!good)
      report_.fail(where, fmt::format("the Draco data has another type or count than {}",
                                      element("accessors", static_cast<std::size_t>(index))));
  }

  Document& document_;
  Report& report_;
  std::map<int, std::unique_ptr<draco::Mesh>> meshes_;
  /// The buffer view and attribute that each accessor was filled from. Attribute -1 stands for the vertex indices.
  std::map<int, std::pair<int, int>> filled_;
};

}  // namespace

void unpack_primitives(Document& document) {
  PrimitiveUnpacker unpacker(document);
  for (const PrimitiveId id : all_primitives(document))
    if (const Value packed = primitive_of(document, id).extension(kDraco)) unpacker.unpack(id, packed);
}

}  // namespace lippmann::gltf
