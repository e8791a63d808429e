#include "report/text_header.h"

#include <fmt/format.h>

#include <cctype>

#include "report/units.h"

namespace rad::report {

namespace {

std::string upper_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string contents_text(const InputReport& input) {
  const validate::ModelFigures& figures = input.result.figures;
  std::string text = input.format.empty() ? "unknown format" : upper_case(input.format);
  text += ", " + byte_size(input.bytes);
  if (!input.read) return text + ", nothing could be read";
  text +=
      fmt::format(", {}, {}, {}, {}", counted(figures.faces, "face"), counted(figures.vertices, "vertex", "vertices"),
                  counted(figures.objects, "object"), counted(figures.materials, "material"));
  if (figures.emitters > 0) text += fmt::format(", {}", counted(figures.emitters, "emitting face"));
  return text;
}

std::string extent_text(const InputReport& input) {
  if (input.box.empty()) return {};
  const geom::dvec3 size = input.box.high - input.box.low;
  std::string text = fmt::format("size {} x {} x {} {}", short_number(size.x), short_number(size.y),
                                 short_number(size.z), unit_label(input.metres_per_unit));
  if (!input.result.tolerance) return text;
  return fmt::format("{}, diagonal {}, {}", text, short_number(input.result.tolerance->diagonal),
                     tolerance_text(*input.result.tolerance, input.metres_per_unit));
}

std::string choice_text(const geom::AutoChoice& choice, std::optional<double> metres_per_unit) {
  const std::string unit = unit_label(metres_per_unit);
  if (choice.confidence == 0) {
    return "auto: no gap of a decade parts noise from features, so T is the default";
  }
  return fmt::format(
      "auto: no vertex has another vertex or edge between {} and {} {} from it, {:.1f} decades; the "
      "default would be {} {}",
      short_number(choice.low), short_number(choice.high), unit, choice.confidence, short_number(choice.usual), unit);
}

void append_choice(std::string& out, const InputReport& input, std::size_t width) {
  if (!input.result.tolerance || !input.result.tolerance->choice) return;
  const geom::AutoChoice& choice = *input.result.tolerance->choice;
  append_wrapped(out, choice_text(choice, input.metres_per_unit), 2, width);
  if (choice.joined == 0) return;
  append_wrapped(out,
                 fmt::format("warning: {} that the default would keep open {} welded at this T",
                             counted(choice.joined, "distance"), choice.joined == 1 ? "is" : "are"),
                 2, width);
}

std::string frame_text(const InputReport& input) {
  std::string unit = "unit not stated (--units m)";
  if (input.metres_per_unit) {
    unit = fmt::format("unit {} ({})", unit_name(*input.metres_per_unit), name(input.units_source));
  }
  std::string up = "up axis not stated (--up z)";
  if (input.up != scene::UpAxis::Unknown) up = fmt::format("up axis {} ({})", name(input.up), name(input.up_source));
  return fmt::format("{}, {}", unit, up);
}

}  // namespace

void append_header(std::string& out, const InputReport& input, const Paint& paint, std::size_t width) {
  out += paint(Ink::Bold, printable(input.path)) + "\n";
  append_wrapped(out, contents_text(input), 2, width);
  append_wrapped(out, extent_text(input), 2, width);
  append_choice(out, input, width);
  if (input.read) append_wrapped(out, frame_text(input), 2, width);
  if (input.result.tolerance && input.result.tolerance->coarse_lattice()) {
    append_wrapped(out,
                   fmt::format("warning: T is only {} steps of the scene lattice, fewer than 32: noise and geometry "
                               "are hard to tell apart",
                               input.result.tolerance->pitches),
                   2, width);
  }
  if (!input.result.incomplete.empty()) append_wrapped(out, "warning: " + printable(input.result.incomplete), 2, width);
}

std::string tolerance_text(const geom::Tolerance& tolerance, std::optional<double> metres_per_unit) {
  std::string text = fmt::format("T {} {}", short_number(tolerance.length), unit_label(metres_per_unit));
  if (metres_per_unit && *metres_per_unit != 0.001) {
    text += fmt::format(" = {} mm", short_number(tolerance.length * *metres_per_unit * 1000));
  }
  return fmt::format("{} ({})", text, geom::name(tolerance.source));
}

}  // namespace rad::report
