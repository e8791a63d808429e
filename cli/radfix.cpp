#include "cli/radfix.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/exit_code.h"
#include "cli/judge.h"
#include "cli/options.h"
#include "cli/report_file.h"
#include "cli/threads.h"
#include "report/repair_report.h"
#include "report/text.h"
#include "writers/registry.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

report::Report report_on(const Model& model) {
  report::Report report;
  report.tool = "radfix";
  report.inputs.push_back(model.report);
  return report;
}

/// What is wrong with the paths, before anything is read.
std::string path_problem(const FixCommand& command) {
  std::error_code error;
  if (!fs::exists(command.input, error)) return command.input + ": no such file";
  if (fs::is_directory(command.input, error)) return command.input + ": is a folder; name one model file";
  if (writers::writer_for(command.output) == nullptr) {
    return command.output + ": not a format that is written; give a name that ends in one of " +
           writers::writable_extensions();
  }
  if (fs::equivalent(command.input, command.output, error)) return command.output + ": is the input; name another file";
  return {};
}

/// Why the model is not written, and with which exit code; kClean where it is.
struct Refusal {
  int exit_code = kClean;
  std::string why;
};

Refusal refusal_of(const Model& model) {
  const report::InputReport& report = model.report;
  if (!report.result.refusal.empty()) return {kUsage, report.result.refusal};
  if (!report.read) return {kUsage, "cannot be read: " + report.result.findings.front().message};
  if (model.content.scene.faces.empty()) return {kRefused, "no surface in it; nothing was written"};
  if (counts(report).errors == 0) return {};
  return {kRefused, fmt::format("not clean at stage model: {}. Repair is not part of this version; nothing was written",
                                error_rules(report))};
}

/// The model as it was read, with the lattice and tolerance that it was judged on.
writers::Output output_of(const Model& model) {
  writers::Output output{model.content.scene};
  const validate::LintResult& result = model.report.result;
  if (result.tolerance) output.lattice = {{result.pitch, result.lattice_origin}, result.tolerance->length};
  return output;
}

/// Writes the report where one is asked for.
bool write_report(const FixCommand& command, const report::RepairReport& report, std::ostream& err) {
  if (command.report.empty()) return true;
  const std::string problem = write_report_file(command.report, report::json(report));
  if (!problem.empty()) err << "radfix: " << problem << '\n';
  return problem.empty();
}

/// Writes the model, reads it back and judges what was written.
int pass_on(const Model& model, const FixCommand& command, const validate::LintOptions& options, std::ostream& out,
            std::ostream& err) {
  const writers::WriteResult written = writers::writer_for(command.output)->write(output_of(model), command.output);
  if (!written.ok()) {
    err << "radfix: " << written.problem << '\n';
    return kUsage;
  }
  Model result = read_model(command.output, command.model);
  judge(result, options);
  if (!write_report(command, {report_on(model), report_on(result)}, err)) return kUsage;
  const report::Counts after = counts(result.report);
  if (after.errors > 0 || !result.report.result.refusal.empty()) {
    err << "radfix: " << command.output << ": written, but errors remain: " << error_rules(result.report) << '\n';
    return kFindings;
  }
  out << fmt::format("{}: clean at stage model; written unchanged to {} and judged again: {}\n", command.input,
                     command.output, report::counts_text(after))
      << std::flush;
  return kClean;
}

int run_fix(const FixCommand& command, std::ostream& out, std::ostream& err) {
  if (const std::string problem = path_problem(command); !problem.empty()) {
    err << "radfix: " << problem << '\n';
    return kUsage;
  }
  const Threads threads(command.model.jobs);
  validate::LintOptions options;
  options.tolerance = command.model.tolerance;
  Model model = read_model(command.input, command.model);
  judge(model, options);
  const Refusal refusal = refusal_of(model);
  if (refusal.exit_code == kClean) return pass_on(model, command, options, out, err);
  err << "radfix: " << command.input << ": " << refusal.why << '\n';
  return write_report(command, {report_on(model), std::nullopt}, err) ? refusal.exit_code : kUsage;
}

}  // namespace

int run_radfix(std::span<const std::string> args, std::ostream& out, std::ostream& err, const Terminal&) {
  const auto command = parse_radfix(args);
  if (const Stop* stop = std::get_if<Stop>(&command)) {
    out << stop->out << std::flush;
    err << stop->err;
    return stop->exit_code;
  }
  return run_fix(std::get<FixCommand>(command), out, err);
}

}  // namespace rad::cli
