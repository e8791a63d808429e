#include "bake/border_balance.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace rad::bake {
namespace {

// Springs, as shares of the weight of a line of weight 1 and a texel's length that ends at the texel: what is evaluated
// stays unless the border needs it otherwise, what lies outside is there for the border.
constexpr double kInsideSpring = 1e-2;
constexpr double kOutsideSpring = 1e-3;
// A difference is judged beside what is there, and beside this share of the brightest of the border where that is
// darker.
constexpr double kDark = 1e-3;
constexpr int kMostSweeps = 60;
// Of the value at hand: sweeps end once no texel changes by more.
constexpr double kSettled = 1e-4;

double brightest(const dvec3& colour) { return std::max({colour.x, colour.y, colour.z}); }

}  // namespace

void BorderBalance::add_edge(const BorderLine& line, double weight) {
  // Along a slanting line through one square of four centres interpolation is quadratic: three values a square hold it.
  constexpr double kSpacing = 0.5;
  const double length = glm::distance(line.from, line.to);
  const double pieces = std::max(1.0, std::ceil(length / kSpacing));
  const auto last_column = static_cast<double>(columns_ - 2), last_row = static_cast<double>(rows_ - 2);
  for (double piece = 0; piece <= pieces; ++piece) {
    const double share = piece / pieces;
    const dvec2 at = line.from + (line.to - line.from) * share;
    const double column = std::clamp(std::floor(at.x), 0.0, last_column);
    const double row = std::clamp(std::floor(at.y), 0.0, last_row);
    const bool is_end = piece == 0 || piece == pieces;
    samples_.push_back({static_cast<std::uint32_t>(column),
                        static_cast<std::uint32_t>(row),
                        {at.x - column, at.y - row},
                        line.value_from + (line.value_to - line.value_from) * share,
                        weight * length / pieces * (is_end ? 0.5 : 1.0)});
  }
}

/// The fit as a bounded least-squares problem, solved by coordinate descent: each texel in turn takes the value that is
/// best while the others stay, or 0. The sum of squares is strictly convex, so this ends at its one least point.
class BorderFit {
 public:
  BorderFit(const BorderBalance& border, const TexelBlock& texels) : border_(border), texels_(texels) {
    for (const auto& sample : border_.samples_) brightest_ = std::max(brightest_, brightest(sample.target));
    find_texels();
    find_uses();
  }

  void run() {
    if (brightest_ <= 0) return;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      double change = 0;
      for (Texel& texel : fitted_) change = std::max(change, improve(texel));
      if (change < kSettled) break;
    }
    for (const Texel& texel : fitted_) {
      float* const value = texels_.at(texel.index % border_.columns_, texel.index / border_.columns_);
      for (int channel = 0; channel < 3; ++channel) value[channel] = static_cast<float>(texel.value[channel]);
    }
  }

 private:
  using Sample = BorderBalance::Sample;
  struct Texel {
    std::uint32_t index = 0;  ///< of the rectangle
    std::uint32_t first_use = 0;
    std::uint32_t end_use = 0;
    double spring = 0;     ///< times the squared change
    double stiffness = 0;  ///< half the second derivative of the sum of squares
    dvec3 start{0, 0, 0};
    dvec3 value{0, 0, 0};
  };
  struct Use {
    std::uint32_t sample = 0;
    double share = 0;  ///< of the texel in what is interpolated
  };

  static double share_of(const Sample& sample, std::uint32_t corner) {
    return (corner % 2 == 1 ? sample.share.x : 1 - sample.share.x) *
           (corner / 2 == 1 ? sample.share.y : 1 - sample.share.y);
  }
  [[nodiscard]] std::uint32_t index_of(const Sample& sample, std::uint32_t corner) const {
    return (sample.row + corner / 2) * border_.columns_ + sample.column + corner % 2;
  }
  [[nodiscard]] Texel& texel_at(std::uint32_t index) {
    return *std::ranges::lower_bound(fitted_, index, {}, &Texel::index);
  }

  void find_texels() {
    std::vector<std::uint32_t> indices;
    for (const Sample& sample : border_.samples_) {
      for (std::uint32_t corner = 0; corner < 4; ++corner) indices.push_back(index_of(sample, corner));
    }
    std::ranges::sort(indices);
    const auto rest = std::ranges::unique(indices);
    indices.erase(rest.begin(), rest.end());
    for (const std::uint32_t index : indices) {
      const float* const value = texels_.at(index % border_.columns_, index / border_.columns_);
      const dvec3 start(value[0], value[1], value[2]);
      fitted_.push_back({.index = index, .start = start, .value = start});
    }
  }

  // What each texel has to do with which samples, and how far each sample is off.
  void find_uses() {
    for (const Sample& sample : border_.samples_) {
      const double scale = std::max(brightest(sample.target), kDark * brightest_);
      weight_.push_back(scale > 0 ? sample.weight / (scale * scale) : 0);
      dvec3& missing = missing_.emplace_back(sample.target);
      for (std::uint32_t corner = 0; corner < 4; ++corner) {
        Texel& texel = texel_at(index_of(sample, corner));
        ++texel.end_use;
        missing -= share_of(sample, corner) * texel.value;
      }
    }
    std::uint32_t uses = 0;
    for (Texel& texel : fitted_) {
      texel.first_use = uses;
      uses += std::exchange(texel.end_use, uses);
    }
    uses_.resize(uses);
    for (std::uint32_t i = 0; i < border_.samples_.size(); ++i) add_uses(i);
    for (Texel& texel : fitted_) {
      texel.spring *= border_.inside_[texel.index] != 0 ? kInsideSpring : kOutsideSpring;
      texel.stiffness += texel.spring;
    }
  }

  void add_uses(std::uint32_t index) {
    const Sample& sample = border_.samples_[index];
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      Texel& texel = texel_at(index_of(sample, corner));
      const double share = share_of(sample, corner);
      uses_[texel.end_use++] = {index, share};
      texel.spring = std::max(texel.spring, sample.weight > 0 ? weight_[index] / sample.weight : 0);
      texel.stiffness += weight_[index] * share * share;
    }
  }

  // How much the value changed, as a share of it.
  double improve(Texel& texel) {
    if (texel.stiffness <= 0) return 0;
    dvec3 pull = texel.spring * (texel.start - texel.value);
    for (std::uint32_t i = texel.first_use; i < texel.end_use; ++i) {
      pull += weight_[uses_[i].sample] * uses_[i].share * missing_[uses_[i].sample];
    }
    const dvec3 next = glm::max(texel.value + pull / texel.stiffness, dvec3(0));
    const dvec3 change = next - texel.value;
    texel.value = next;
    for (std::uint32_t i = texel.first_use; i < texel.end_use; ++i) {
      missing_[uses_[i].sample] -= uses_[i].share * change;
    }
    return brightest(glm::abs(change)) / std::max(brightest(next), kDark * brightest_);
  }

  const BorderBalance& border_;
  const TexelBlock& texels_;
  double brightest_ = 0;
  std::vector<Texel> fitted_;  ///< by index
  std::vector<Use> uses_;      ///< of each texel one after another
  std::vector<double> weight_;
  std::vector<dvec3> missing_;  ///< of each sample
};

void BorderBalance::settle(const TexelBlock& texels) const { BorderFit(*this, texels).run(); }

}  // namespace rad::bake
