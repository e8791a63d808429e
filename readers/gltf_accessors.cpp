#include "readers/gltf_accessors.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rad::readers::gltf {

namespace {

static_assert(std::endian::native == std::endian::little, "accessors are read as they lie in the little-endian file");

template <typename Stored>
double load_as(const char* bytes) {
  Stored value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double load(const char* bytes, ComponentType type) {
  switch (type) {
    case ComponentType::Byte:
      return load_as<std::int8_t>(bytes);
    case ComponentType::UnsignedByte:
      return load_as<std::uint8_t>(bytes);
    case ComponentType::Short:
      return load_as<std::int16_t>(bytes);
    case ComponentType::UnsignedShort:
      return load_as<std::uint16_t>(bytes);
    case ComponentType::UnsignedInt:
      return load_as<std::uint32_t>(bytes);
    case ComponentType::Float:
      break;
  }
  return load_as<float>(bytes);
}

std::uint64_t size_of(ComponentType type) {
  switch (type) {
    case ComponentType::Byte:
    case ComponentType::UnsignedByte:
      return 1;
    case ComponentType::Short:
    case ComponentType::UnsignedShort:
      return 2;
    default:
      return 4;
  }
}

bool is_index_type(ComponentType type) {
  return type == ComponentType::UnsignedByte || type == ComponentType::UnsignedShort ||
         type == ComponentType::UnsignedInt;
}

int components_of(std::string_view type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  return type == "VEC4" ? 4 : 0;
}

/// Value is double, or std::uint32_t for a type that is_index_type and not normalised: every such value fits.
template <typename Value>
Value load_value(const char* bytes, ComponentType type, bool normalized) {
  const double stored = load(bytes, type);
  return static_cast<Value>(normalized ? normalized_value(stored, type) : stored);
}

}  // namespace

std::optional<ComponentType> component_type(std::uint64_t code) {
  if (code < 5120 || code > 5126 || code == 5124) return std::nullopt;
  return static_cast<ComponentType>(code);
}

double normalized_value(double stored, ComponentType type) {
  switch (type) {
    case ComponentType::Byte:
      return std::max(stored / 127.0, -1.0);
    case ComponentType::UnsignedByte:
      return stored / 255.0;
    case ComponentType::Short:
      return std::max(stored / 32767.0, -1.0);
    case ComponentType::UnsignedShort:
      return stored / 65535.0;
    default:
      return stored;
  }
}

/// Bytes and stride of an accessor's dense part; no bytes where all of it is zero.
struct Accessors::Elements {
  std::string_view bytes;
  std::uint64_t stride = 0;

  [[nodiscard]] bool are_zero() const { return bytes.empty(); }
  [[nodiscard]] const char* at(std::uint64_t element) const { return bytes.data() + element * stride; }
};

void Accessors::report(std::string what, const JsonView& json) const {
  add_parse_error(document_.issues, std::move(what), json.pointer());
}

std::optional<AccessorShape> Accessors::shape(std::uint64_t index, std::string_view type) const {
  const JsonView json = document_.root().item("accessors", index);
  if (!json) return std::nullopt;
  const auto code = json.whole("componentType");
  const auto component = code ? component_type(*code) : std::nullopt;
  const auto count = json.whole("count");
  if (!component || !count) {
    report("the accessor lacks a sound componentType or count", json);
    return std::nullopt;
  }
  if (json.text("type") != type) {
    report("the accessor is not of type " + std::string(type), json);
    return std::nullopt;
  }
  return AccessorShape{index,
                       *count,
                       json.whole("byteOffset").value_or(0),
                       components_of(type),
                       *component,
                       json.flag("normalized").value_or(false)};
}

std::optional<Accessors::Elements> Accessors::elements(const AccessorShape& shape, const JsonView& json) const {
  const auto view_index = json.whole("bufferView");
  if (!view_index) {
    if (shape.count <= buffers_.backing_bytes()) return Elements{};
    report("the accessor counts more elements than the file has bytes", json);
    return std::nullopt;
  }
  const auto bytes = buffers_.view(*view_index);
  if (!bytes) return std::nullopt;
  const std::uint64_t element_bytes = size_of(shape.type) * static_cast<std::uint64_t>(shape.components);
  const JsonView view = document_.root().item("bufferViews", *view_index);
  const std::uint64_t stride = view.whole("byteStride").value_or(element_bytes);
  if (stride < element_bytes) {
    report("byteStride " + std::to_string(stride) + " is below the element size " + std::to_string(element_bytes),
           view);
    return std::nullopt;
  }
  if (shape.count == 0) return Elements{};
  const bool fits = shape.offset <= bytes->size() && element_bytes <= bytes->size() - shape.offset &&
                    (shape.count - 1) <= (bytes->size() - shape.offset - element_bytes) / stride;
  if (fits) return Elements{bytes->substr(shape.offset), stride};
  report("the accessor's " + std::to_string(shape.count) + " elements reach beyond its buffer view", json);
  return std::nullopt;
}

template <typename Value>
std::optional<std::vector<Value>> Accessors::values(const AccessorShape& shape) const {
  const JsonView json = document_.root().item("accessors", shape.index);
  const auto elements = this->elements(shape, json);
  if (!elements) return std::nullopt;
  const auto components = static_cast<std::uint64_t>(shape.components);
  std::vector<Value> values(shape.count * components, Value{0});
  if (!elements->are_zero()) {
    auto value = values.begin();
    for (std::uint64_t i = 0; i < shape.count; ++i) {
      for (std::uint64_t c = 0; c < components; ++c) {
        *value++ = load_value<Value>(elements->at(i) + c * size_of(shape.type), shape.type, shape.normalized);
      }
    }
  }
  if (json.has("sparse") && !apply_sparse(shape, json.object("sparse"), values)) return std::nullopt;
  return values;
}

std::optional<std::string_view> Accessors::packed(const JsonView& json, std::uint64_t count,
                                                  std::uint64_t element_bytes) const {
  const auto view_index = json.whole("bufferView");
  if (!view_index) {
    report("the sparse accessor names no buffer view", json);
    return std::nullopt;
  }
  const auto bytes = buffers_.view(*view_index);
  if (!bytes) return std::nullopt;
  const std::uint64_t offset = json.whole("byteOffset").value_or(0);
  if (offset <= bytes->size() && count <= (bytes->size() - offset) / element_bytes) return bytes->substr(offset);
  report("the sparse accessor's " + std::to_string(count) + " elements reach beyond their buffer view", json);
  return std::nullopt;
}

template <typename Value>
bool Accessors::apply_sparse(const AccessorShape& shape, const JsonView& sparse, std::vector<Value>& values) const {
  const std::uint64_t count = sparse.whole("count").value_or(0);
  const JsonView places = sparse.object("indices");
  const auto place_type = component_type(places.whole("componentType").value_or(0));
  if (!sparse || !place_type || !is_index_type(*place_type)) {
    report("the sparse accessor has no sound indices", sparse ? sparse : document_.root());
    return false;
  }
  const auto components = static_cast<std::uint64_t>(shape.components);
  const std::uint64_t component_bytes = size_of(shape.type);
  const auto place_bytes = packed(places, count, size_of(*place_type));
  const JsonView substitutes = sparse.object("values");
  const auto value_bytes = packed(substitutes ? substitutes : sparse, count, component_bytes * components);
  if (!place_bytes || !value_bytes) return false;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto place = static_cast<std::uint64_t>(load(place_bytes->data() + i * size_of(*place_type), *place_type));
    if (place >= shape.count) {
      report("sparse index " + std::to_string(place) + " exceeds the accessor's " + std::to_string(shape.count) +
                 " elements",
             places);
      return false;
    }
    for (std::uint64_t c = 0; c < components; ++c) {
      const char* bytes = value_bytes->data() + (i * components + c) * component_bytes;
      values[place * components + c] = load_value<Value>(bytes, shape.type, shape.normalized);
    }
  }
  return true;
}

std::optional<std::vector<double>> Accessors::numbers(std::uint64_t index, std::string_view type) const {
  const auto shape = this->shape(index, type);
  return shape ? values<double>(*shape) : std::nullopt;
}

std::optional<std::vector<std::uint32_t>> Accessors::indices(std::uint64_t index) const {
  const auto shape = this->shape(index, "SCALAR");
  if (!shape) return std::nullopt;
  if (is_index_type(shape->type) && !shape->normalized) return values<std::uint32_t>(*shape);
  report("indices are not plain unsigned integers", document_.root().item("accessors", index));
  return std::nullopt;
}

}  // namespace rad::readers::gltf
