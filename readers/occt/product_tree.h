// The solids of a CAD document: where they are placed, and their names and colours.
#pragma once

#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rad::readers::occt {

/// A part of an assembly, placed.
struct Part {
  TopoDS_Shape shape;
  std::string name;                     ///< of the part, after those of the assemblies around it: "frame/bolt"
  std::optional<std::uint32_t> colour;  ///< 0xRRGGBB of the part as a whole
};

/// All parts in the order of the document; assemblies nested deeper than `depth` are left out.
std::vector<Part> parts_of(const Handle(TDocStd_Document) & document, std::uint64_t depth);

/// The colour of a face, where the document gives it one of its own.
std::optional<std::uint32_t> colour_of_face(const Handle(TDocStd_Document) & document, const TopoDS_Shape& face);

}  // namespace rad::readers::occt
