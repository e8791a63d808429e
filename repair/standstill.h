// Tells when the rounds of the residual loop do not get any further.
#pragma once

#include <cstddef>
#include <optional>
#include <tuple>

namespace rad::repair {

class Standstill {
 public:
  /// What a round begins with; less is better, the first that differs counts.
  struct Left {
    bool folded = false;  ///< a plane map is none
    bool worse = false;   ///< other violations than contacts
    std::size_t violations = 0;
    std::size_t triangles = 0;  ///< of the whole model; does not count

    [[nodiscard]] auto rank() const { return std::tuple(folded, worse, violations); }
  };

  /// Takes note of a round. True where the last kPatience rounds left no less than the best before them, or where the
  /// triangles have become so many that the cures make more than they cure.
  bool after(const Left& left) {
    if (!best_) most_triangles_ = kMostGrowth * (left.triangles + kFewTriangles);
    if (!best_ || left.rank() < best_->rank()) {
      best_ = left;
      rounds_since_ = 0;
      return false;
    }
    ran_away_ = left.triangles > most_triangles_;
    return ++rounds_since_ > kPatience || ran_away_;
  }
  /// Whether the last round had too many triangles.
  [[nodiscard]] bool ran_away() const { return ran_away_; }

 private:
  // Measured on 700 hard scenes: rounds that ended clean went through at most 54 in a row that left no less than the
  // best before, and grew a model by 4.6 at most.
  static constexpr std::size_t kPatience = 55;
  static constexpr std::size_t kMostGrowth = 6;
  static constexpr std::size_t kFewTriangles = 100;

  std::optional<Left> best_;
  std::size_t rounds_since_ = 0;
  std::size_t most_triangles_ = 0;
  bool ran_away_ = false;
};

}  // namespace rad::repair
