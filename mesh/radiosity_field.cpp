#include "mesh/radiosity_field.h"

#include <algorithm>
#include <cmath>

namespace rad::mesh {

double EnergyLedger::unshot_share() const {
  double share = 0;
  for (int channel = 0; channel < 3; ++channel) {
    if (emitted[channel] > 0) share = std::max(share, std::abs(unshot[channel]) / emitted[channel]);
  }
  return share;
}

}  // namespace rad::mesh
