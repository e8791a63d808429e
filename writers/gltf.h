// Writing a scene as glTF 2.0: one file (.glb), or a JSON document with its bytes beside it (.gltf and .bin).
#pragma once

#include <filesystem>

#include "writers/model.h"

namespace rad::writers {

/// Writes a GLB. One mesh and node for each object that has faces, one primitive for each of its materials; primitives
/// of a mesh share their vertices, which are those that its faces use, in the order of the scene. Positions are floats
/// relative to the lattice origin, and exact on the lattice; the origin is the translation of a root node, left out
/// where it is zero. Without a lattice the floats are relative to a place near the box centre, or to zero where that
/// loses nothing. With light, materials are unlit, COLOR_0 is the colour and _RADIOSITY the radiosity (W/m²), and
/// reflectance and exitance stand in the extras of the material. With a light map they show its pages instead of
/// COLOR_0 (light_map_material_json), one primitive for each material and page; TEXCOORD_1 has its coordinates.
/// Vertices are split where corners differ in normal (NORMAL) or texture coordinates (TEXCOORD_0); positions are then
/// the same to the bit. The image of a material is written where its faces have coordinates, by its URI or with its
/// bytes. A mesh bears the name of its faces' group, or of the object where they have none; of an object with several
/// groups the primitives say theirs in extras.radfix.
/// Problems: a face that triangles_of does not split; a position, coordinate or radiosity that a float cannot hold; a
/// file beyond 4 GiB. Lost, for glTF has no place for it: smoothing groups, the order of faces, vertices without a
/// face, materials without a face, the unit and the up axis of the scene (numbers are kept); with light, images. Bytes
/// of names that are not UTF-8 become U+FFFD.
WriteResult write_glb(const Output& output, const std::filesystem::path& path);

/// The same with KHR_draco_mesh_compression, which its readers must know. Nothing is lost: on a lattice positions are
/// quantised on the grid of its pitch over the whole scene, and all else stands as it is; what is written is decoded
/// and compared. Problem: triangles that Draco does not keep.
WriteResult write_draco_glb(const Output& output, const std::filesystem::path& path);

/// The plain one as a JSON document; its bytes go to the .bin of the same stem, which is in place before the document.
WriteResult write_gltf(const Output& output, const std::filesystem::path& path);

}  // namespace rad::writers
