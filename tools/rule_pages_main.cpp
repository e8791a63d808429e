// Writes docs/rules/ from the text that stands with the rules and pictures of their example models, or checks that it
// is what would be written.
//
//   rad_rule_pages docs/rules           writes
//   rad_rule_pages --check docs/rules   exit 1 and the names of pages that are stale, missing or left over

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "report/rule_page.h"
#include "tools/rule_pictures.h"
#include "validate/registry.h"

namespace {

namespace fs = std::filesystem;
using Pages = std::map<std::string, std::string>;

/// Of a picture: pages with two of them are to open at once.
constexpr std::size_t kMostBytes = 15'000;

bool is_picture(const std::string& name) { return name.ends_with(".png"); }

Pages pages() {
  Pages result;
  const auto rules = rad::validate::all_rules();
  result["README.md"] = rad::report::rules_markdown(rules);
  for (const rad::validate::Rule* rule : rules) {
    const fs::path folder = fs::path(RAD_RULE_MODELS) / rad::report::fixture_folder(*rule);
    const std::string id(rule->id);
    rad::report::PageExamples examples;
    if (auto [fail, pass] = rad::tools::rule_pictures(*rule, folder); !fail.empty()) {
      examples = {"pictures/" + id + "-fail.png", "pictures/" + id + "-pass.png"};
      result[examples.fail] = std::move(fail);
      result[examples.pass] = std::move(pass);
    }
    result[id + ".md"] = rad::report::rule_markdown(*rule, examples);
  }
  return result;
}

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

int check(const fs::path& folder, const Pages& wanted) {
  int stale = 0;
  const auto complain = [&stale](const std::string& name, const char* what) {
    std::cerr << name << ": " << what << '\n';
    ++stale;
  };
  for (const auto& [name, text] : wanted) {
    const std::string held = content_of(folder / name);
    const bool fresh = is_picture(name) ? rad::tools::shows_the_same(held, text) : held == text;
    if (is_picture(name) && held.size() > kMostBytes) complain(name, "is larger than 15 kB");
    if (!fresh) complain(name, "differs from the rule; run rad_rule_pages docs/rules");
  }
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    if (entry.is_regular_file() && !wanted.contains(name)) complain(name, "no such rule");
  }
  return stale == 0 ? 0 : 1;
}

int write(const fs::path& folder, const Pages& wanted) {
  fs::create_directories(folder / "pictures");
  for (const auto& [name, text] : wanted) {
    std::ofstream stream(folder / name, std::ios::binary);
    stream << text;
    if (!stream.flush()) {
      std::cerr << name << ": cannot be written\n";
      return 2;
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (args.size() == 1) return write(args[0], pages());
  if (args.size() == 2 && args[0] == "--check") return check(args[1], pages());
  std::cerr << "usage: rad_rule_pages [--check] FOLDER\n";
  return 2;
}
