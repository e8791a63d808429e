// Style and script of the page, as web/ and report/html/ hold them. Made by cmake/embed_page.py.
#pragma once

#include <string_view>

namespace rad::report::html {

/// `hash` is a source expression of a Content-Security-Policy, "sha256-…".
struct Asset {
  std::string_view text;
  std::string_view hash;
};

const Asset& page_style();
const Asset& page_script();

}  // namespace rad::report::html
