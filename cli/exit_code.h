// What the programs tell the shell.
#pragma once

namespace rad::cli {

/// Exit codes of both programs; Refused is radfix's only.
enum ExitCode : int {
  kClean = 0,       ///< radlint: nothing at or above --fail-on. radfix: written, read back and clean
  kFindings = 1,    ///< radlint: findings at or above --fail-on. radfix: written, but errors remain
  kUsage = 2,       ///< usage, a path that does not exist, a report that cannot be written, a tolerance refused
  kIncomplete = 3,  ///< judged in part only: a limit of the machine was hit
  kRefused = 4,     ///< radfix wrote nothing
};

}  // namespace rad::cli
