// A patch as receivers see it that are not near: a mean and two slopes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solve/coupling_source.h"

namespace rad::solve {

/// What arrives of the mean and the two slopes of a radiator.
using FarWeight = std::array<float, 3>;

struct FarRequest {
  ReceiverId receiver = 0;
  double importance = 0;  ///< Importance::of the radiator and a patch of the receiver
};

enum class Seen : std::uint8_t { BelowHorizon, Whole, Partly, Blocked };

struct FarView {
  FarWeight weight{0, 0, 0};
  float share = 0;  ///< of the irradiance, were nothing in the way
  Seen seen = Seen::BelowHorizon;
};

/// Strata are made when they are needed first, so an object is for one thread.
class FarRadiator {
 public:
  FarRadiator(const CouplingSource& source, mesh::PatchId patch);

  /// Appends one view for each request, in their order. The same for the same request whatever the others are.
  void look(std::span<const FarRequest> requests, std::vector<FarView>& views);

 private:
  /// A piece of the patch.
  struct Piece {
    dvec3 centre;
    double area = 0;
    std::array<double, 2> coordinates{};  ///< Radiator::coordinates of the centre
  };
  struct Level {
    std::vector<Stratum> stratum;
    std::vector<Piece> piece;
  };
  /// One receiver on its way through the levels.
  struct Look {
    const Receiver* receiver = nullptr;
    double plane_distance = 0;        ///< of the receiver from the plane of the patch
    double factor = 0;                ///< form factor, were nothing in the way
    std::array<double, 2> slope{};    ///< form factors of the two slopes, likewise
    std::array<double, 3> all{};      ///< sums over the strata of a level
    std::array<double, 3> visible{};  ///< over those of them that are seen
    std::uint32_t visible_count = 0;
    std::uint32_t last_visible = 0;  ///< stratum
    std::uint32_t blocked_count = 0;
    int level = 0;
    int last_level = 0;
    bool near = false;   ///< nearer than kernels of the pieces are equal
    bool exact = false;  ///< strata by their own form factors, cut at the horizon
  };
  struct Ray {
    std::uint32_t look = 0;
    std::uint32_t stratum = 0;
    double factor = 0;                    ///< form factor of what it stands for
    std::array<double, 2> coordinates{};  ///< likewise
  };

  [[nodiscard]] Piece piece_of(const Stratum& stratum) const;
  const Level& level(int number);
  [[nodiscard]] double kernel(const Look& look, const Piece& piece) const;
  [[nodiscard]] Look begin(const FarRequest& request) const;
  void measure(Look& look) const;
  [[nodiscard]] Segment ray(const FarRequest& request, const Look& look, std::uint32_t stratum, std::uint32_t attempt);
  void aim(const FarRequest& request, std::uint32_t index, Look& look);
  bool aim_by_kernel(const FarRequest& request, std::uint32_t index, const Look& look);
  void trace_level(std::span<const FarRequest> requests, std::span<Look> looks);
  void confirm_lone(const FarRequest& request, Look& look);
  [[nodiscard]] FarView view_of(const FarRequest& request, const Look& look) const;

  const CouplingSource& source_;
  mesh::PatchId patch_;
  const Radiator& radiator_;
  dvec3 normal_;
  Stratum whole_;
  std::vector<Piece> points_;  ///< of a quadrature over the patch, their weights as areas
  std::array<Level, kDeepestStrata + 1> levels_;
  std::vector<Segment> segments_;
  std::vector<Ray> rays_;
  std::vector<std::uint8_t> blocked_;
};

}  // namespace rad::solve
