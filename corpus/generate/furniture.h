// Furniture as it stands in exported models: legs through the floor, papers and rugs as sheets in the plane that they
// lie on, books side by side. Frames are plans with the floor at 0; a thing stands from the origin along u and v, its
// front at v = 0.
#pragma once

#include "corpus/generate/exported.h"

namespace rad::corpus {

/// How far legs and posts stand in the floor, millimetres.
inline constexpr int kSunk = 6;

void define_furniture_materials(Modeller& modeller);

void add_table(Exporter& exporter, const Frame& frame, Planar size, int height);
void add_desk(Exporter& exporter, const Frame& frame);   ///< 1600 x 800, papers on it
void add_chair(Exporter& exporter, const Frame& frame);  ///< 450 x 450, its back at v = 450
void add_stool(Exporter& exporter, const Frame& frame);
void add_sofa(Exporter& exporter, const Frame& frame, int seats);
void add_bed(Exporter& exporter, const Frame& frame);
void add_wardrobe(Exporter& exporter, const Frame& frame, int doors);
void add_drawers(Exporter& exporter, const Frame& frame, Planar size, int height, int drawers);
void add_bookshelf(Exporter& exporter, const Frame& frame, int width, int boards);
void add_piano(Exporter& exporter, const Frame& frame);  ///< a grand piano, 1500 x 1900, keys at v = 0
void add_plant(Exporter& exporter, const Frame& frame);

void add_rug(Exporter& exporter, const Frame& frame, Planar size, std::string_view material);
void add_picture(Exporter& exporter, const Frame& plan, int width, int foot, int height);  ///< flat on a wall
void add_curtain(Exporter& exporter, const Frame& frame, int folds, int height);
void add_radiator(Exporter& exporter, const Frame& frame, int ribs);

void add_ceiling_lamp(Exporter& exporter, const Frame& frame, int ceiling, int radius);
void add_floor_lamp(Exporter& exporter, const Frame& frame);
void add_table_lamp(Exporter& exporter, const Frame& frame, int foot);
void add_chandelier(Exporter& exporter, const Frame& frame, int ceiling, int bulbs);

}  // namespace rad::corpus
