// Tasks in worker processes: one that crashes, hangs or takes too much memory costs itself and nothing else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace rad::batch {

/// What one task may take.
struct TaskLimits {
  std::optional<double> seconds;       ///< of wall clock
  std::optional<std::uint64_t> bytes;  ///< of memory that is written to
};

/// How a task ended.
enum class Ending : std::uint8_t {
  Done,
  TimeLimit,
  OutOfMemory,  ///< the limit was reached, or there was no more
  Failed,       ///< it threw
  Died,         ///< its process did
};

struct TaskOutcome {
  Ending ending = Ending::Died;
  std::string bytes;  ///< Done: what the task returned. Failed: what was thrown
  int signal = 0;     ///< Died: by this signal; 0 where the process left by itself
};

struct Pool {
  std::size_t workers = 1;  ///< processes at a time
  std::size_t threads = 1;  ///< to be shared among the tasks that run at a time
  TaskLimits limits;
  /// In a worker: does task number `task` with at most so many threads.
  std::function<std::string(std::size_t task, std::size_t threads)> work;
  /// In this process: a task has ended. In the order in which they end.
  std::function<void(std::size_t task, TaskOutcome outcome)> ended;
  /// Asked often; true kills the workers.
  std::function<bool()> stopped;
};

/// Runs the tasks, handing them out in the order given. Forks: no other thread may live in this process. False where it
/// was stopped. Throws std::system_error where no process can be made.
bool run_tasks(std::span<const std::size_t> tasks, const Pool& pool);

}  // namespace rad::batch
