// What the head of a DXF file says of all entities: its unit and its layers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "readers/dxf_groups.h"

namespace rad::readers::dxf {

/// The length of $INSUNITS in metres; nothing for 0 (without unit) and unknown values.
std::optional<double> metres_of_insertion_unit(std::int64_t code);

struct Layer {
  std::string name;
  int colour = 7;                            ///< index
  std::optional<std::uint32_t> true_colour;  ///< 0xRRGGBB, before the index
  bool visible = true;                       ///< neither off nor frozen
};

/// Layers by name; DXF does not tell upper and lower case apart.
class Layers {
 public:
  void add(const Entity& record);
  /// A layer that no table has is white and visible.
  [[nodiscard]] const Layer& find(std::string_view name);

 private:
  std::map<std::string, Layer> layers_;
};

/// Reads section HEADER, which `groups` stands in, up to ENDSEC. Gives the unit that it declares.
std::optional<double> read_header_unit(Groups& groups);

/// Reads section TABLES up to ENDSEC.
void read_layers(Groups& groups, Layers& layers, scene::ReadIssues& issues);

/// A name in upper case, as DXF compares names.
std::string folded(std::string_view name);

}  // namespace rad::readers::dxf
