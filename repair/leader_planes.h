// Plane clusters without drift: every face is held against the plane of the largest face around, never against its
// neighbour, so that the facets of a cylinder do not creep into one plane.
#pragma once

#include <vector>

#include "repair/complex.h"
#include "repair/soup.h"

namespace rad::repair {

struct LeaderPlane {
  Plane plane;
  double area = 0;  ///< of the pieces claimed, pitches²
};

struct PlaneClaims {
  std::vector<LeaderPlane> leaders;        ///< by area of the leading piece, largest first
  std::vector<ClusterId> leader_of_piece;  ///< per piece
};

/// Claims pieces for planes. A leader claims a piece that comes within `proximity` pitches of what it has, has all
/// corners within `band` pitches of the leader's plane and is turned from it by less than 45° (either way round).
PlaneClaims claim_planes(const Soup& soup, double band, double proximity);

}  // namespace rad::repair
