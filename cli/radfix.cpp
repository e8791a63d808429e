#include "cli/radfix.h"

#include <fmt/format.h>

#include <algorithm>

#include "bake/png.h"
#include "bake/preview.h"
#include "cli/exit_code.h"
#include "cli/fix_paths.h"
#include "cli/fix_stages.h"
#include "cli/judge.h"
#include "cli/options.h"
#include "cli/report_file.h"
#include "cli/threads.h"
#include "repair/planar_caps.h"
#include "repair/two_sided.h"
#include "report/repair_report.h"
#include "report/repair_text.h"
#include "writers/registry.h"
#include "writers/whole_file.h"

namespace rad::cli {

namespace {

report::Report report_on(const Model& model) {
  report::Report report;
  report.tool = "radfix";
  report.inputs.push_back(model.report);
  return report;
}

/// Why the model is not written, and with which exit code; kClean where it is.
struct Refusal {
  int exit_code = kClean;
  std::string why;
};

// What only leaving faces out would cure: corners that name no vertex or are no numbers. That is not done unasked.
report::InputReport losses_in(report::InputReport report) {
  std::erase_if(report.result.findings, [](const scene::Finding& finding) {
    return finding.severity != scene::Severity::Error || finding.fix.applicability != scene::FixClass::Unsafe;
  });
  return report;
}

Refusal refusal_of(const Model& model) {
  const report::InputReport& report = model.report;
  if (!report.result.refusal.empty()) return {kUsage, report.result.refusal};
  if (!report.read) return {kUsage, "cannot be read: " + report.result.findings.front().message};
  if (model.content.scene.faces.empty()) return {kRefused, "no surface in it; nothing was written"};
  const report::InputReport losses = losses_in(report);
  if (losses.result.findings.empty()) return {};
  const std::uint64_t line = losses.result.findings.front().where.line;
  return {kRefused, fmt::format("faces would be lost ({}{}), so nothing was written", error_rules(losses),
                                line > 0 ? fmt::format(", first at line {}", line) : std::string())};
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
  report.repair = product.repair;
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

/// Says what was done and found; returns the exit code.
int conclude(const report::RepairReport& report, const FixCommand& command, const Terminal& terminal, std::ostream& out,
             std::ostream& err) {
  out << report::text(report, {use_color(ColorChoice::Auto, terminal), terminal.columns, command.preview})
      << std::flush;
  const report::InputReport& after = report.after->inputs.front();
  if (!after.result.refusal.empty()) {
    err << "radfix: " << command.output << ": written, but cannot be judged: " << after.result.refusal << '\n';
    return kFindings;
  }
  const std::string remain = error_rules(after);
  if (report.incomplete) {
    err << "radfix: " << command.output << ": written, but incomplete: stopped before the end"
        << (remain.empty() ? "" : "; errors remain: ") << remain << '\n';
    return kIncomplete;
  }
  if (remain.empty()) return kClean;
  err << "radfix: " << command.output << ": written, but errors remain: " << remain << '\n';
  return kFindings;
}

/// Writes the product, reads it back and judges what was written.
int deliver(const Model& before, const Product& product, const FixCommand& command, const Terminal& terminal,
            std::ostream& out, std::ostream& err) {
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
  report.after->stage = options.stage;
  if (!write_report(command, report, err)) return kUsage;
  return conclude(report, command, terminal, out, err);
}

/// Adds the faces that the command asks for to the model, and notes them; says what was asked for in vain.
std::string add_requested_faces(const FixCommand& command, Model& model, scene::Ledger& ledger) {
  scene::Scene& scene = model.content.scene;
  if (command.cap_planar) {
    repair::Capped capped = repair::with_planar_caps(scene, model.content.issues, command.model.tolerance);
    scene = std::move(capped.scene);
    if (capped.caps > 0) ledger.push_back({"facades", "cap-opening", capped.caps, 0});
  }
  repair::Doubled doubled = repair::with_twins(std::move(scene), command.two_sided);
  scene = std::move(doubled.scene);
  if (doubled.twins > 0) ledger.push_back({"facades", "add-twin", doubled.twins, 0});
  if (doubled.unmatched.empty()) return {};
  return fmt::format("--two-sided: no object and no material matches '{}'", doubled.unmatched);
}

int run_fix(const FixCommand& command, const Terminal& terminal, std::ostream& out, std::ostream& err) {
  if (const std::string problem = fix_path_problem(command); !problem.empty()) {
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
  scene::Ledger requested;
  const Refusal refusal = refusal_of(model);
  if (refusal.exit_code != kClean) {
    product.exit_code = refusal.exit_code;
    product.problem = refusal.why;
  } else if (product.problem = add_requested_faces(command, model, requested); !product.problem.empty()) {
    product.exit_code = kUsage;
  } else {
    product = make_product(model, command, writers::writer_for(command.output)->triangles_only, line, watch);
  }
  product.ledger.insert(product.ledger.begin(), requested.begin(), requested.end());
  line.wipe();
  if (product.problem.empty()) return deliver(model, product, command, terminal, out, err);
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
