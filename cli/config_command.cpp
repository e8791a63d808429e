#include "cli/config_command.h"

#include "cli/config_view.h"
#include "cli/exit_code.h"
#include "cli/lint_reports.h"

namespace rad::cli {

int run_config(const ConfigCommand& command, std::ostream& out, std::ostream& err) {
  const std::string path = command.how.paths.empty() ? "." : command.how.paths.front();
  RunSettings settings(command.how);
  const ConfigView view = config_view(settings, command.how, path);
  const std::string text = command.format == PageFormat::Json ? config_json(view) : config_text(view);
  return write_to_stdout(out, err, text) ? kClean : kUsage;
}

}  // namespace rad::cli
