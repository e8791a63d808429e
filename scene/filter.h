// The filters of the pipeline, named as the paper names its programs (paper 3; Orient is the one that it presupposes).
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace rad::scene {

/// In running order.
enum class Filter : std::uint8_t { Grouper, Isect, Coplanar, Orient, Pmesh, Emesh, Solve, Bake };

inline constexpr std::array kFilters{Filter::Grouper, Filter::Isect, Filter::Coplanar, Filter::Orient,
                                     Filter::Pmesh,   Filter::Emesh, Filter::Solve,    Filter::Bake};

/// "grouper", "isect"…
std::string_view name(Filter filter);
std::optional<Filter> parse_filter(std::string_view text);

class FilterSet {
 public:
  constexpr FilterSet() = default;
  constexpr FilterSet(std::initializer_list<Filter> filters) {
    for (const Filter filter : filters) add(filter);
  }
  /// The first filters, up to and with `last`.
  static constexpr FilterSet until(Filter last) {
    FilterSet set;
    for (const Filter filter : kFilters) {
      if (filter <= last) set.add(filter);
    }
    return set;
  }

  constexpr void add(Filter filter) { bits_ = static_cast<std::uint8_t>(bits_ | bit(filter)); }
  constexpr void remove(Filter filter) { bits_ = static_cast<std::uint8_t>(bits_ & ~bit(filter)); }
  constexpr void remove(const FilterSet& others) { bits_ = static_cast<std::uint8_t>(bits_ & ~others.bits_); }
  [[nodiscard]] constexpr bool has(Filter filter) const { return (bits_ & bit(filter)) != 0; }
  [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
  [[nodiscard]] constexpr FilterSet common(const FilterSet& other) const {
    FilterSet set;
    set.bits_ = static_cast<std::uint8_t>(bits_ & other.bits_);
    return set;
  }
  friend constexpr bool operator==(const FilterSet&, const FilterSet&) = default;

 private:
  static constexpr std::uint8_t bit(Filter filter) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(filter));
  }
  std::uint8_t bits_ = 0;
};

/// Those that repair: all before the mesh.
inline constexpr FilterSet kRepairFilters = FilterSet::until(Filter::Orient);

/// "grouper, isect".
std::string names(const FilterSet& filters);

}  // namespace rad::scene
