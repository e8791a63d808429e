// A radiosity solution: values at the nodes and where the energy went.
#pragma once

#include <string>
#include <vector>

#include "geom/vec.h"

namespace rad::mesh {

/// Power by where it went, W per channel. Every watt emitted or reflected is shot once: emitted + reflected = shot +
/// unshot, and shot = received + escaped, received = reflected + absorbed. Received is what fronts get by the integral
/// of the nodes' values, so escaped also holds, with either sign, the error of that integral: in a closed model all of
/// it.
struct EnergyLedger {
  geom::dvec3 emitted{0, 0, 0};
  geom::dvec3 shot{0, 0, 0};
  geom::dvec3 received{0, 0, 0};
  geom::dvec3 reflected{0, 0, 0};
  geom::dvec3 absorbed{0, 0, 0};
  geom::dvec3 escaped{0, 0, 0};  ///< into open space, or into the backs of faces
  geom::dvec3 unshot{0, 0, 0};

  /// The largest share over the channels of unshot in emitted; 0 without emission.
  [[nodiscard]] double unshot_share() const;
};

/// B at every node of a RadiosityMesh: linear RGB in W/m², own emission included.
struct RadiosityField {
  std::vector<geom::dvec3> radiosity;
  EnergyLedger energy;
  std::size_t shots = 0;
  bool complete = true;  ///< false where it was stopped before unshot fell below the limit
};

}  // namespace rad::mesh
