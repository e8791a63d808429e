#include "readers/rad_xform.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <optional>

#include "readers/text_cursor.h"

namespace rad::readers::radiance {
namespace {

using glm::dmat4;
using glm::dvec3;

/// Transformations that are repeated together: 0 to `count` - 1 times for the copies of an array, `count` times
/// otherwise.
struct Stretch {
  dmat4 matrix{1.0};
  std::uint64_t count = 1;
  bool is_array = false;
};

class Parser {
 public:
  Parser(std::span<const std::string> words, std::uint64_t limit) : words_(words), limit_(limit) {}

  Xform run() {
    while (at_ < words_.size() && words_[at_].starts_with('-') && xform_.problem.empty()) {
      if (!take_option()) take_transformation();
    }
    for (; at_ < words_.size(); ++at_) xform_.files.push_back(words_[at_]);
    if (xform_.problem.empty()) make_copies();
    return std::move(xform_);
  }

 private:
  // -n, -m, -I, -c and -e come before all others, but xform does not mind.
  bool take_option() {
    const std::string& word = words_[at_];
    if (word == "-c" || word == "-e") {
      ++at_;
      return true;
    }
    if (word == "-I") {
      xform_.inverted = !xform_.inverted;
      ++at_;
      return true;
    }
    if (word != "-n" && word != "-m") return false;
    if (at_ + 1 >= words_.size()) return fail("lacks the name after " + word);
    std::string& name = word == "-n" ? prefix_ : xform_.modifier;
    name = word == "-n" && !name.empty() ? name + "." + words_[at_ + 1] : words_[at_ + 1];
    at_ += 2;
    return true;
  }

  void take_transformation() {
    const std::string word = words_[at_++];
    if (word == "-t") {
      if (const auto by = vector()) apply(glm::translate(dmat4(1.0), *by));
    } else if (word == "-rx" || word == "-ry" || word == "-rz") {
      const dvec3 axis(word == "-rx", word == "-ry", word == "-rz");
      if (const auto angle = number()) apply(glm::rotate(dmat4(1.0), *angle * std::numbers::pi / 180, axis));
    } else if (word == "-mx" || word == "-my" || word == "-mz") {
      apply(glm::scale(dmat4(1.0), dvec3(word == "-mx" ? -1 : 1, word == "-my" ? -1 : 1, word == "-mz" ? -1 : 1)));
    } else if (word == "-s") {
      const auto factor = number();
      if (factor && *factor == 0) fail("scales by 0");
      if (factor) apply(glm::scale(dmat4(1.0), dvec3(*factor)));
    } else if (word == "-a" || word == "-i") {
      if (const auto count = whole()) stretches_.push_back({dmat4(1.0), *count, word == "-a"});
    } else {
      fail("has the argument " + in_quotes(word) + ", which is not followed");
    }
  }

  void apply(const dmat4& matrix) { stretches_.back().matrix = matrix * stretches_.back().matrix; }

  bool fail(std::string why) {
    if (xform_.problem.empty()) xform_.problem = std::move(why);
    return true;
  }

  std::optional<double> number() {
    const auto value = at_ < words_.size() ? parse_number(words_[at_++]) : std::nullopt;
    if (value && std::isfinite(*value)) return value;
    fail("lacks a number");
    return std::nullopt;
  }

  std::optional<dvec3> vector() {
    const auto x = number(), y = number(), z = number();
    if (!x || !y || !z) return std::nullopt;
    return dvec3(*x, *y, *z);
  }

  std::optional<std::uint64_t> whole() {
    const auto value = at_ < words_.size() ? parse_integer(words_[at_++]) : std::nullopt;
    if (value && *value >= 0 && static_cast<std::uint64_t>(*value) <= limit_) return static_cast<std::uint64_t>(*value);
    fail("has a count that is no whole number, or beyond the limit of " + std::to_string(limit_));
    return std::nullopt;
  }

  void make_copies() {
    xform_.copies.assign(1, {dmat4(1.0), prefix_});
    bool named = !prefix_.empty();
    for (const Stretch& stretch : stretches_) {
      if (!stretch.is_array) {
        repeat(stretch);
        continue;
      }
      if (stretch.count == 0) return void(fail("has an array of no copies"));
      if (xform_.copies.size() * stretch.count > limit_) return void(fail("makes more copies than the limit"));
      make_array(stretch, named);
      named = true;
    }
    for (PlacedCopy& copy : xform_.copies) {
      if (!copy.prefix.empty()) copy.prefix += '.';
    }
  }

  // By doubling: the count is the file's.
  void repeat(const Stretch& stretch) {
    dmat4 power(1.0), square = stretch.matrix;
    for (std::uint64_t left = stretch.count; left > 0; left /= 2) {
      if (left % 2 == 1) power = square * power;
      square = square * square;
    }
    for (PlacedCopy& copy : xform_.copies) copy.matrix = power * copy.matrix;
  }

  // Unnamed arrays number their copies a0, a1…; the copies of copies a0.0, a0.1….
  void make_array(const Stretch& stretch, bool named) {
    std::vector<PlacedCopy> copies;
    copies.reserve(xform_.copies.size() * stretch.count);
    for (const PlacedCopy& copy : xform_.copies) {
      dmat4 matrix = copy.matrix;
      for (std::uint64_t i = 0; i < stretch.count; ++i) {
        copies.push_back({matrix, (named ? copy.prefix + "." : "a") + std::to_string(i)});
        matrix = stretch.matrix * matrix;
      }
    }
    xform_.copies = std::move(copies);
  }

  std::span<const std::string> words_;
  std::uint64_t limit_;
  std::size_t at_ = 0;
  std::string prefix_;
  std::vector<Stretch> stretches_{Stretch()};
  Xform xform_;
};

}  // namespace

Xform parse_xform(std::span<const std::string> words, std::uint64_t limit) { return Parser(words, limit).run(); }

}  // namespace rad::readers::radiance
