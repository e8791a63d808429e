#include "batch/worker_pool.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <list>
#include <new>
#include <system_error>
#include <vector>

#include "batch/worker_channel.h"

namespace rad::batch {

namespace {

using Clock = std::chrono::steady_clock;

constexpr char kDone = 'd', kOutOfMemory = 'm', kFailed = 'f';
constexpr int kLongestWaitMilliseconds = 200;  // between two looks at whether the run was stopped

struct Worker {
  pid_t process = -1;
  int socket = -1;
  std::size_t task = 0;
  bool busy = false;
  Clock::time_point deadline = Clock::time_point::max();
  AnswerBuffer answer{};
};

void limit_memory(const std::optional<std::uint64_t>& bytes) {
  if (!bytes) return;
  const rlimit limit{*bytes, *bytes};
  ::setrlimit(RLIMIT_DATA, &limit);
}

/// False where the worker is of no more use.
bool answer_task(int socket, const TaskMessage& message, const Pool& pool) {
  try {
    return send_answer(socket, kDone, pool.work(message.task, message.threads));
  } catch (const std::bad_alloc&) {
    send_answer(socket, kOutOfMemory, {});
    return false;
  } catch (const std::exception& error) {
    return send_answer(socket, kFailed, error.what());
  }
}

// An interrupt from the keyboard goes to the whole group: what it means is for the parent to say.
[[noreturn]] void live_as_worker(int socket, const Pool& pool, pid_t parent) {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  limit_memory(pool.limits.bytes);
  while (const auto message = receive_task(socket)) {
    if (!answer_task(socket, *message, pool)) break;
  }
  ::_exit(0);
}

class PoolRun {
 public:
  PoolRun(std::span<const std::size_t> tasks, const Pool& pool) : waiting_(tasks), pool_(pool) {}
  PoolRun(const PoolRun&) = delete;
  PoolRun& operator=(const PoolRun&) = delete;
  ~PoolRun() {
    for (Worker& worker : workers_) {
      ::kill(worker.process, SIGKILL);
      bury(worker);
    }
  }

  bool run() {
    while (!pool_.stopped || !pool_.stopped()) {
      hand_out();
      if (workers_.empty()) return true;
      wait_for_answers();
      end_late_tasks();
    }
    return false;
  }

 private:
  void hand_out() {
    for (auto worker = workers_.begin(); worker != workers_.end();) {
      const bool keep = worker->busy || (!waiting_.empty() && give_task(*worker));
      worker = keep ? std::next(worker) : dismiss(worker);
    }
    while (!waiting_.empty() && workers_.size() < std::max<std::size_t>(pool_.workers, 1)) {
      workers_.push_back(hire());
      if (!give_task(workers_.back())) throw std::system_error(EPIPE, std::generic_category(), "a worker process");
    }
  }

  Worker hire() {
    int sockets[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) {
      throw std::system_error(errno, std::generic_category(), "a socket for a worker process");
    }
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process < 0) {
      const int error = errno;
      ::close(sockets[0]);
      ::close(sockets[1]);
      throw std::system_error(error, std::generic_category(), "a worker process");
    }
    if (process == 0) {
      ::close(sockets[0]);
      // Else a worker would not see the end of the stream when this process is gone.
      for (const Worker& other : workers_) ::close(other.socket);
      live_as_worker(sockets[1], pool_, parent);
    }
    ::close(sockets[1]);
    Worker worker;
    worker.process = process;
    worker.socket = sockets[0];
    return worker;
  }

  bool give_task(Worker& worker) {
    const std::size_t at_a_time =
        std::clamp<std::size_t>(waiting_.size() + busy_, 1, std::max<std::size_t>(pool_.workers, 1));
    const TaskMessage message{waiting_.front(), std::max<std::size_t>(pool_.threads / at_a_time, 1)};
    if (!send_task(worker.socket, message)) return false;
    worker.task = waiting_.front();
    waiting_ = waiting_.subspan(1);
    worker.busy = true;
    ++busy_;
    worker.deadline = Clock::time_point::max();
    if (pool_.limits.seconds) {
      worker.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(*pool_.limits.seconds));
    }
    return true;
  }

  // Freed memory may stay with a process: under a limit every task gets a fresh one.
  [[nodiscard]] bool single_use() const { return pool_.limits.bytes.has_value(); }

  std::list<Worker>::iterator dismiss(std::list<Worker>::iterator worker) {
    ::shutdown(worker->socket, SHUT_RDWR);
    bury(*worker);
    return workers_.erase(worker);
  }

  /// Gives the signal that ended the process, 0 for none.
  static int bury(Worker& worker) {
    ::close(worker.socket);
    int status = 0;
    while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }

  [[nodiscard]] int milliseconds_to_wait() const {
    auto wait = std::chrono::milliseconds(kLongestWaitMilliseconds);
    const Clock::time_point now = Clock::now();
    for (const Worker& worker : workers_) {
      if (worker.deadline == Clock::time_point::max()) continue;
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(worker.deadline - now);
      wait = std::clamp(left, std::chrono::milliseconds(0), wait);
    }
    return static_cast<int>(wait.count());
  }

  void wait_for_answers() {
    std::vector<pollfd> sockets;
    for (const Worker& worker : workers_) sockets.push_back({worker.socket, POLLIN, 0});
    if (::poll(sockets.data(), sockets.size(), milliseconds_to_wait()) <= 0) return;
    auto worker = workers_.begin();
    for (const pollfd& socket : sockets) {
      worker = socket.revents == 0 ? std::next(worker) : hear(worker);
    }
  }

  std::list<Worker>::iterator hear(std::list<Worker>::iterator worker) {
    if (!worker->answer.read_from(worker->socket)) return mourn(worker);
    if (!worker->answer.complete()) return std::next(worker);
    const char letter = worker->answer.ending();
    const Ending ending = letter == kDone ? Ending::Done : letter == kFailed ? Ending::Failed : Ending::OutOfMemory;
    end_task(*worker, {ending, worker->answer.take(), 0});
    return single_use() || ending == Ending::OutOfMemory ? dismiss(worker) : std::next(worker);
  }

  std::list<Worker>::iterator mourn(std::list<Worker>::iterator worker) {
    const int signal = bury(*worker);
    end_task(*worker, {Ending::Died, {}, signal});
    return workers_.erase(worker);
  }

  void end_task(Worker& worker, TaskOutcome outcome) {
    worker.busy = false;
    worker.deadline = Clock::time_point::max();
    --busy_;
    pool_.ended(worker.task, std::move(outcome));
  }

  void end_late_tasks() {
    const Clock::time_point now = Clock::now();
    for (auto worker = workers_.begin(); worker != workers_.end();) {
      if (!worker->busy || now < worker->deadline) {
        ++worker;
        continue;
      }
      ::kill(worker->process, SIGKILL);
      bury(*worker);
      end_task(*worker, {Ending::TimeLimit, {}, 0});
      worker = workers_.erase(worker);
    }
  }

  std::span<const std::size_t> waiting_;
  const Pool& pool_;
  std::list<Worker> workers_;
  std::size_t busy_ = 0;
};

}  // namespace

bool run_tasks(std::span<const std::size_t> tasks, const Pool& pool) { return PoolRun(tasks, pool).run(); }

}  // namespace rad::batch
