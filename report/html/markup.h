// Small pieces of the page that several of its parts use.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "report/html/model_view.h"
#include "report/report.h"

namespace rad::report::html {

/// A sign and its word: a diamond for an error, a triangle for a warning, a disc for a note.
std::string severity_sign(scene::Severity severity);

/// The same signs, and a tick where all is well.
enum class Sign : std::uint8_t { Diamond, Triangle, Disc, Tick, Blank };
std::string sign(Sign sign);

/// An img element with the picture in it; empty for an empty picture.
std::string image(const Picture& picture, std::string_view text_instead, std::string_view css_class);

/// "f-0-3": element of finding 3 of input 0, counted among those that are listed.
std::string finding_id(std::size_t input, std::size_t finding);

/// "r-0-RL201-error": element of the findings of a rule in an input.
std::string rule_anchor(std::size_t input, const scene::Finding& finding);

}  // namespace rad::report::html
