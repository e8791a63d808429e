// "Did you mean".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rad::config {

/// The candidate that fewest edits turn `text` into; the first of equals. Empty where all take more than half the
/// length of `text`, plus one.
std::string_view nearest(std::string_view text, std::span<const std::string_view> candidates);

/// "; did you mean x?", or nothing for an empty suggestion.
std::string did_you_mean(std::string_view suggestion);

}  // namespace rad::config
