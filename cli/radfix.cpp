#include "cli/radfix.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "bake/png.h"
#include "bake/preview.h"
#include "cli/exit_code.h"
#include "cli/fix_stages.h"
#include "cli/judge.h"
#include "cli/options.h"
#include "cli/report_file.h"
#include "cli/threads.h"
#include "report/repair_report.h"
#include "report/text.h"
#include "writers/registry.h"
#include "writers/whole_file.h"

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

// Faces that name no vertex or have a corner that is no number would be lost: that is not done without being asked.
bool would_lose_faces(const report::InputReport& report) {
  return std::ranges::any_of(report.result.findings, [](const scene::Finding& finding) {
    return finding.severity == scene::Severity::Error && finding.fix.applicability == scene::FixClass::Unsafe;
  });
}

Refusal refusal_of(const Model& model) {
  const report::InputReport& report = model.report;
  if (!report.result.refusal.empty()) return {kUsage, report.result.refusal};
  if (!report.read) return {kUsage, "cannot be read: " + report.result.findings.front().message};
  if (model.content.scene.faces.empty()) return {kRefused, "no surface in it; nothing was written"};
  if (!would_lose_faces(report)) return {};
  return {kRefused, fmt::format("repair would have to leave faces out: {}. Nothing was written", error_rules(report))};
}

/// Writes the report where one is asked for.
bool write_report(const FixCommand& command, const report::RepairReport& report, std::ostream& err) {
  if (command.report.empty()) return true;
  const std::string problem = write_report_file(command.report, report::json(report));
  if (!problem.empty()) err << "radfix: " << problem << '\n';
  return problem.empty();
}

report::RepairReport report_of(const Model& before, const Product& product, const FixCommand& command) {
  report::RepairReport report{report_on(before), std::nullopt};
  report.ledger = product.ledger;
  report.mesh = product.mesh;
  report.solution = product.solution;
  report.incomplete = product.incomplete;
  if (command.timings) report.timings = product.timings;
  return report;
}

std::string write_preview(const Product& product, const FixCommand& command) {
  if (command.preview.empty()) return {};
  const bake::Image picture = bake::render(product.scene, product.light ? &*product.light : nullptr);
  return writers::write_whole_file(command.preview, bake::png_bytes(picture));
}

std::string_view stage_reached(const FixCommand& command) {
  return command.solve ? "display" : command.mesh ? "solve" : "model";
}

// One line for each thing that was done.
void print_work(const Product& product, std::ostream& out) {
  for (const scene::LedgerEntry& entry : product.ledger) {
    out << fmt::format("  {:<9} {:<20} {:>8}", entry.stage, entry.operation, entry.count);
    if (entry.largest_movement > 0) {
      out << fmt::format("  up to {:.2g} T", entry.largest_movement / product.lattice.tolerance);
    }
    out << '\n';
  }
  if (product.mesh) {
    out << fmt::format("  mesh      {} faces, {} patches, {} elements, {} nodes\n", product.mesh->faces,
                       product.mesh->patches, product.mesh->elements, product.mesh->nodes);
  }
  if (product.solution) {
    out << fmt::format("  solve     {} shots, {:.2g} % of the light unshot\n", product.solution->shots,
                       100 * product.solution->energy.unshot_share());
  }
}

/// Says what was done and found; returns the exit code.
int conclude(const Product& product, const Model& after, const FixCommand& command, std::ostream& out,
             std::ostream& err) {
  const report::Counts left = counts(after.report);
  out << fmt::format("{}: {} {}\n", command.input, product.untouched ? "written unchanged to" : "repaired,",
                     command.output);
  print_work(product, out);
  out << fmt::format("  judged again at stage {}: {}\n", stage_reached(command), report::counts_text(left));
  if (!command.preview.empty()) out << fmt::format("  picture: {}\n", command.preview);
  out << std::flush;
  if (left.errors > 0 || !after.report.result.refusal.empty()) {
    err << "radfix: " << command.output << ": written, but errors remain: " << error_rules(after.report) << '\n';
    return kFindings;
  }
  if (!product.incomplete) return kClean;
  err << "radfix: " << command.output << ": written, but incomplete: stopped before the end\n";
  return kIncomplete;
}

/// Writes the product, reads it back and judges what was written.
int deliver(const Model& before, const Product& product, const FixCommand& command, std::ostream& out,
            std::ostream& err) {
  writers::Output output{product.scene};
  output.light = product.light ? &*product.light : nullptr;
  output.lattice = product.lattice;
  output.marked_incomplete = product.incomplete;
  const writers::WriteResult written = writers::writer_for(command.output)->write(output, command.output);
  std::string problem = written.problem;
  if (problem.empty()) problem = write_preview(product, command);
  if (!problem.empty()) {
    err << "radfix: " << problem << '\n';
    return kUsage;
  }
  Model after = read_model(command.output, command.model);
  validate::LintOptions options;
  options.stage = *validate::parse_stage(stage_reached(command));
  options.tolerance = {product.lattice.tolerance, geom::ToleranceRequest::Measure::FileUnits};
  judge(after, options);
  report::RepairReport report = report_of(before, product, command);
  report.after = report_on(after);
  if (!write_report(command, report, err)) return kUsage;
  return conclude(product, after, command, out, err);
}

int run_fix(const FixCommand& command, const Terminal& terminal, std::ostream& out, std::ostream& err) {
  if (const std::string problem = path_problem(command); !problem.empty()) {
    err << "radfix: " << problem << '\n';
    return kUsage;
  }
  const Threads threads(command.model.jobs);
  LiveLine line(err, terminal.err_is_terminal);
  const InterruptWatch watch;
  line.show("reading");
  Model model = read_model(command.input, command.model);
  validate::LintOptions options;
  options.tolerance = command.model.tolerance;
  line.show("judging");
  judge(model, options);
  Product product;
  const Refusal refusal = refusal_of(model);
  if (refusal.exit_code != kClean) {
    product.exit_code = refusal.exit_code;
    product.problem = refusal.why;
  } else {
    product = make_product(model, command, writers::writer_for(command.output)->triangles_only, line, watch);
  }
  line.wipe();
  if (product.problem.empty()) return deliver(model, product, command, out, err);
  err << "radfix: " << command.input << ": " << product.problem << '\n';
  return write_report(command, report_of(model, product, command), err) ? product.exit_code : kUsage;
}

}  // namespace

int run_radfix(std::span<const std::string> args, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  const auto command = parse_radfix(args);
  if (const Stop* stop = std::get_if<Stop>(&command)) {
    out << stop->out << std::flush;
    err << stop->err;
    return stop->exit_code;
  }
  return run_fix(std::get<FixCommand>(command), terminal, out, err);
}

}  // namespace rad::cli
