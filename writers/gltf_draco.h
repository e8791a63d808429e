// KHR_draco_mesh_compression: a glTF document with its triangles in Draco streams, and nothing lost.
#pragma once

#include <string>
#include <string_view>

#include "writers/gltf_materials.h"

namespace rad::writers::gltf {

struct DracoDocument {
  std::string problem;  ///< why there is none; empty where all is well
  Json json;
  std::string buffer;
};

/// Compresses the primitives of a document of this writer, whose accessors point into `buffer`. With a `pitch` above 0,
/// of which all positions are to be multiples, all primitives are quantised on one grid of that step over the whole
/// document: what is at one place stays at one place, and decoding gives the same floats. Every other attribute, and
/// positions that are on no grid, are stored as they are. Every stream is decoded again and held against what went in,
/// triangle by triangle and bit by bit.
/// Triangles and vertices change their order. The reader needs the extension: there is no plain copy in the document.
DracoDocument draco_document(const Json& plain, std::string_view buffer, double pitch);

}  // namespace rad::writers::gltf
