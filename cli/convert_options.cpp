// The command line of radfix convert.
#include "cli/convert.h"
#include "cli/option_parser.h"

namespace rad::cli {

namespace {

constexpr const char* kFooter = R"(Examples:
  radfix convert plan.dxf plan.obj         the same faces in another format
  radfix convert --list                    what each format holds

Nothing is repaired: `radfix IN -o OUT` does that. Faces are divided where the
format needs it.)";

}  // namespace

std::variant<ConvertCommand, Stop> parse_convert(std::span<const std::string> args) {
  CLI::App app("Writes a model in another format, and says what that format loses.", "radfix convert");
  ConvertCommand command;
  ModelWords words;
  prepare(app, kFooter);
  app.add_option("input", command.input, "Model file")->type_name("IN");
  app.add_option("output", command.output, "A name in one of the formats that are written")->type_name("OUT");
  app.add_flag("--list", command.list, "List the formats and what they hold");
  add_model_options(app, words);
  if (auto stop = parse(app, args)) return *stop;
  if (std::string fault = read_model_words(words, command.model); !fault.empty()) return usage_error("radfix", fault);
  if (!command.list && command.output.empty())
    return usage_error("radfix", "convert: name the model and the file to write");
  return command;
}

}  // namespace rad::cli
