#include "cli/radfix.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/annotation.h"
#include "cli/carried_images.h"
#include "cli/contracts.h"
#include "cli/convert.h"
#include "cli/deliver.h"
#include "cli/exit_code.h"
#include "cli/fix_judging.h"
#include "cli/fix_only.h"
#include "cli/fix_paths.h"
#include "cli/fix_report.h"
#include "cli/fix_stages.h"
#include "cli/judge.h"
#include "cli/options.h"
#include "cli/report_file.h"
#include "cli/threads.h"
#include "config/fault.h"
#include "repair/planar_caps.h"
#include "repair/two_sided.h"
#include "report/repair_report.h"
#include "report/repair_text.h"
#include "scene/bad_faces.h"
#include "writers/registry.h"

namespace rad::cli {

namespace {

/// Why the model is not written, and with which exit code; kClean where it is.
struct Refusal {
  int exit_code = kClean;
  std::string why;
};

// What only leaving faces out would cure: corners that name no vertex or are no numbers. That is not done unasked.
std::vector<scene::Finding> losses_in(std::vector<scene::Finding> findings) {
  std::erase_if(findings, [](const scene::Finding& finding) {
    return finding.severity != scene::Severity::Error || finding.fix.applicability != scene::FixClass::Unsafe;
  });
  return findings;
}

/// `found` is what is found in the model whatever is configured.
Refusal refusal_of(const Model& model, const validate::LintResult& found, const FixCommand& command) {
  if (!found.refusal.empty()) return {kUsage, found.refusal};
  if (!model.report.read) return {kUsage, "cannot be read: " + found.findings.front().message};
  if (model.content.scene.faces.empty()) return {kRefused, "no surface in it; nothing was written"};
  if (const std::string others = inseparable_rules(command, found.findings); !others.empty()) return {kUsage, others};
  const std::vector<scene::Finding> losses = losses_in(found.findings);
  if (losses.empty() || command.unsafe_fixes) return {};
  const std::uint64_t line = losses.front().where.line;
  return {kRefused,
          fmt::format("faces would be lost ({}{}), so nothing was written; --unsafe-fixes leaves them out",
                      error_rules(losses), line > 0 ? fmt::format(", first at line {}", line) : std::string())};
}

class RadfixRun {
 public:
  RadfixRun(const FixCommand& command, const FixJudging& judging, const Terminal& terminal, std::ostream& out,
            std::ostream& err)
      : command_(command),
        judging_(judging),
        terminal_(terminal),
        out_(out),
        err_(err),
        line_(err, terminal.err_is_terminal) {}

  int run() {
    if (const std::string problem = fix_path_problem(command_); !problem.empty()) return complain(problem);
    const Threads threads(command_.model.jobs);
    line_.show("reading");
    model_ = read_model(command_.input, command_.model);
    line_.show("judging");
    const validate::LintResult found = judge_input(model_, judging_);
    if (const Refusal refusal = refusal_of(model_, found, command_); refusal.exit_code != kClean) {
      product_.exit_code = refusal.exit_code;
      product_.problem = refusal.why;
      return give_up();
    }
    leave_out_bad_faces();
    if (const std::string problem = add_requested_faces(); !problem.empty()) {
      product_.exit_code = kUsage;
      product_.problem = problem;
      return give_up();
    }
    if (command_.check_contracts) contracts_ = check_contracts(model_, command_, line_, watch_);
    product_ = make_product(model_, command_, target(), line_, watch_);
    product_.left_out = before_repair_;
    line_.wipe();
    for (const std::string& what : product_.work.rolled_back) complain(named(what));
    return product_.problem.empty() ? finish() : give_up();
  }

 private:
  int complain(const std::string& what) {
    err_ << "radfix: " << what << '\n';
    return kUsage;
  }
  [[nodiscard]] std::string named(const std::string& what) const { return command_.input + ": " + what; }

  [[nodiscard]] RepairTarget target() const {
    if (command_.output.empty()) return {};
    if (command_.output == kStream) return {.triangles = false, .stage = true};
    const writers::Writer& writer = *writers::writer_for(command_.output);
    return {writer.triangles_only, writer.between_filters};
  }

  void leave_out_bad_faces() {
    if (!command_.unsafe_fixes) return;
    std::uint64_t count = scene::drop_bad_faces(model_.content.scene);
    for (const scene::ReadIssue& issue : model_.content.issues.all()) {
      if (issue.kind == scene::ReadIssueKind::IndexOutOfRange) count += issue.count;
    }
    if (count > 0) before_repair_.push_back({"input", "drop-bad-faces", {"RL002", "RL003"}, count, 0, std::nullopt});
  }

  /// Adds the faces that the command asks for to the model; says what was asked for in vain.
  std::string add_requested_faces() {
    scene::Scene& scene = model_.content.scene;
    if (command_.cap_planar) {
      repair::Capped capped = repair::with_planar_caps(scene, model_.content.issues, command_.model.tolerance);
      scene = std::move(capped.scene);
      if (capped.caps > 0)
        before_repair_.push_back({"facades", "cap-opening", {"RL101"}, capped.caps, 0, std::nullopt});
    }
    repair::Doubled doubled = repair::with_twins(std::move(scene), command_.two_sided);
    scene = std::move(doubled.scene);
    if (doubled.twins > 0) before_repair_.push_back({"facades", "add-twin", {"RL113"}, doubled.twins, 0, std::nullopt});
    if (doubled.unmatched.empty()) return {};
    return fmt::format("--two-sided: no object and no material matches '{}'", doubled.unmatched);
  }

  /// Writes the reports that are asked for.
  bool write_reports(const report::RepairReport& report) {
    bool all = true;
    for (const FileReport& file : command_.reports) {
      const std::string problem = write_report_file(file.path, written_report(report, file, command_));
      if (problem.empty()) continue;
      complain(problem);
      all = false;
    }
    return all;
  }

  int give_up() {
    line_.wipe();
    complain(named(product_.problem));
    report::RepairReport report = report_of(model_, product_, command_);
    report.contracts = contracts_;
    return write_reports(report) ? product_.exit_code : kUsage;
  }

  int finish() {
    if (!command_.dry_run && command_.output != kStream) {
      const std::string problem = bring_images(product_.scene, command_.input, command_.output);
      if (!problem.empty()) return complain(problem);
    }
    Delivered delivered = deliver(product_, command_, judging_of_result(model_, judging_), out_);
    if (!delivered.problem.empty()) return complain(delivered.problem);
    if (!command_.annotate.empty()) {
      const std::string problem = write_annotation(command_.annotate, model_, product_, history_of(model_, product_));
      if (!problem.empty()) return complain(problem);
    }
    report::RepairReport report = report_of(model_, product_, command_);
    report.contracts = contracts_;
    report.awaited = delivered.awaited;
    report.after.emplace();
    report.after->tool = "radfix";
    report.after->stage = stage_reached(command_);
    report.after->inputs.push_back(delivered.model.report);
    return write_reports(report) ? conclude(report, delivered.twin) : kUsage;
  }

  /// Says what was done and found; returns the exit code.
  int conclude(const report::RepairReport& report, const std::optional<Model>& twin) {
    if (command_.output != kStream || command_.dry_run) {
      report::RepairTextOptions options{use_color(ColorChoice::Auto, terminal_),
                                        terminal_.columns,
                                        command_.preview,
                                        command_.annotate,
                                        command_.diff,
                                        twin ? twin->report.path : std::string(),
                                        twin ? twin->report.bytes : 0,
                                        command_.viewer};
      out_ << report::text(report, options) << std::flush;
    }
    const report::InputReport& after = report.after->inputs.front();
    if (!after.result.refusal.empty()) {
      complain(written("but cannot be judged: " + after.result.refusal));
      return kFindings;
    }
    const std::string remain =
        report::counts(after).errors > report.awaited ? error_rules(after.result.findings) : std::string();
    if (report.incomplete) {
      complain(
          written("but incomplete: stopped before the end" + (remain.empty() ? "" : "; errors remain: " + remain)));
      return kIncomplete;
    }
    const std::string broken = contracts_ ? broken_contracts(*contracts_) : std::string();
    if (!broken.empty()) complain(named("contract broken: " + broken));
    if (!remain.empty()) complain(written("but errors remain: " + remain));
    const std::string drifted = drifted_places();
    if (!drifted.empty()) complain(written("but " + drifted));
    const bool worse_twin = twin && report::counts(twin->report).errors > report::counts(after).errors;
    if (worse_twin)
      complain(twin->report.path + ": has errors of its own: " + error_rules(twin->report.result.findings));
    return remain.empty() && broken.empty() && drifted.empty() && !worse_twin ? kClean : kFindings;
  }

  [[nodiscard]] std::string drifted_places() const {
    const repair::Repaired& repaired = product_.work.repaired;
    if (repaired.drifted == 0) return {};
    const geom::dvec3& at = repaired.drifted_at;
    return fmt::format("surfaces lie farther than 8 T from where they were, in {} {}, one at ({:.6g}, {:.6g}, {:.6g})",
                       repaired.drifted, repaired.drifted == 1 ? "place" : "places", at.x, at.y, at.z);
  }

  [[nodiscard]] std::string written(const std::string& how) const {
    if (command_.dry_run) return fmt::format("{}: would be written, {}", command_.input, how);
    return fmt::format("{}: written, {}", command_.output, how);
  }

  const FixCommand& command_;
  const FixJudging& judging_;
  const Terminal& terminal_;
  std::ostream& out_;
  std::ostream& err_;
  LiveLine line_;
  const InterruptWatch watch_;
  Model model_;
  Product product_;
  scene::Ledger before_repair_;  ///< what was left out and added as asked
  std::optional<std::vector<report::ContractCheck>> contracts_;
};

}  // namespace

int run_radfix(std::span<const std::string> args, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  if (!args.empty() && args.front() == "convert") return run_convert(args.subspan(1), out, err);
  auto command = parse_radfix(args);
  if (const Stop* stop = std::get_if<Stop>(&command)) {
    out << stop->out << std::flush;
    err << stop->err;
    return stop->exit_code;
  }
  auto& fix = std::get<FixCommand>(command);
  try {
    const FixJudging judging = configure(fix);
    return RadfixRun(fix, judging, terminal, out, err).run();
  } catch (const config::ConfigFault& fault) {
    err << "radfix: " << fault.what() << '\n';
    return kUsage;
  }
}

}  // namespace rad::cli
