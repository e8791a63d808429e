// Accessors of a glTF document: typed, strided, normalised and sparse arrays over buffer views.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "readers/gltf_buffers.h"

namespace rad::readers::gltf {

enum class ComponentType : std::uint16_t {
  Byte = 5120,
  UnsignedByte = 5121,
  Short = 5122,
  UnsignedShort = 5123,
  UnsignedInt = 5125,
  Float = 5126,
};

/// The component type of this glTF code; nothing for a code that glTF does not know.
std::optional<ComponentType> component_type(std::uint64_t code);

/// The value that a stored integer stands for where an accessor is normalised: 0..1 or -1..1. Floats and unsigned
/// ints stay as they are.
double normalized_value(double stored, ComponentType type);

/// What an accessor says of itself, without its bytes.
struct AccessorShape {
  std::uint64_t index = 0;
  std::uint64_t count = 0;
  std::uint64_t offset = 0;  ///< bytes from the start of the buffer view
  int components = 0;
  ComponentType type = ComponentType::Float;
  bool normalized = false;
};

/// Reads accessors. Every count is held against the bytes behind it before memory is taken; what fails is reported
/// as a ParseError (or as the missing buffer) and gives nothing.
class Accessors {
 public:
  Accessors(const Document& document, const Buffers& buffers) : document_(document), buffers_(buffers) {}

  /// Nothing where the accessor does not exist or is not of `type` ("SCALAR", "VEC2", "VEC3", "VEC4").
  [[nodiscard]] std::optional<AccessorShape> shape(std::uint64_t index, std::string_view type) const;

  /// All components, element after element, after normalisation; floats as they stand, finite or not.
  [[nodiscard]] std::optional<std::vector<double>> numbers(std::uint64_t index, std::string_view type) const;

  /// Vertex indices: a scalar accessor of unsigned integers.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> indices(std::uint64_t index) const;

 private:
  struct Elements;

  [[nodiscard]] std::optional<Elements> elements(const AccessorShape& shape, const JsonView& json) const;
  template <typename Value>
  [[nodiscard]] std::optional<std::vector<Value>> values(const AccessorShape& shape) const;
  template <typename Value>
  [[nodiscard]] bool apply_sparse(const AccessorShape& shape, const JsonView& sparse, std::vector<Value>& values) const;
  [[nodiscard]] std::optional<std::string_view> packed(const JsonView& json, std::uint64_t count,
                                                       std::uint64_t element_bytes) const;
  void report(std::string what, const JsonView& json) const;

  const Document& document_;
  const Buffers& buffers_;
};

}  // namespace rad::readers::gltf
