// Random numbers that are a function of what they are for, so that they depend neither on order nor on threads.
#pragma once

#include <array>
#include <cstdint>

namespace rad::solve {

/// The finaliser of SplitMix64: a bijection in which every bit of the input changes half of the bits of the output.
constexpr std::uint64_t mixed(std::uint64_t bits) {
  bits ^= bits >> 30;
  bits *= 0xbf58476d1ce4e5b9u;
  bits ^= bits >> 27;
  bits *= 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

/// Two numbers in (0, 1), the same for the same four keys.
constexpr std::array<double, 2> jitter(std::uint32_t radiator, std::uint32_t receiver, std::uint32_t stratum,
                                       std::uint32_t round) {
  const std::uint64_t pair = (static_cast<std::uint64_t>(radiator) << 32) | receiver;
  const std::uint64_t sample = (static_cast<std::uint64_t>(round) << 32) | stratum;
  const std::uint64_t bits = mixed(mixed(pair + 0x9e3779b97f4a7c15u) ^ (sample * 0xd1b54a32d192ed03u + 1));
  const auto high = static_cast<double>(bits >> 32);
  const auto low = static_cast<double>(bits & 0xffffffffu);
  return {(high + 0.5) * 0x1p-32, (low + 0.5) * 0x1p-32};
}

}  // namespace rad::solve
