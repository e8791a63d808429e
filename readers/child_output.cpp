#include "readers/child_output.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>

extern char** environ;

namespace rad::readers {
namespace {

using Clock = std::chrono::steady_clock;

/// A pipe of which the child holds the end that is written.
struct Pipe {
  int read_end = -1, write_end = -1;

  bool open() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    read_end = ends[0];
    write_end = ends[1];
    return true;
  }
  void close_write_end() {
    if (write_end >= 0) ::close(write_end);
    write_end = -1;
  }
  ~Pipe() {
    close_write_end();
    if (read_end >= 0) ::close(read_end);
  }
};

int spawn(const std::vector<std::string>& words, const std::string& folder, int output, pid_t& child) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const int error = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

// Empty where the output came to its end.
std::string collect(int descriptor, std::uint64_t limit, Clock::time_point until, std::string& text) {
  std::array<char, 1 << 16> buffer{};
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd waiting{descriptor, POLLIN, 0};
    const int ready = left > 0 ? ::poll(&waiting, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return "it took too long and was stopped";
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return {};
    if (text.size() + static_cast<std::size_t>(count) > limit) return "it said more than the limit and was stopped";
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

ChildOutput output_of(const std::vector<std::string>& words, const std::string& folder, std::uint64_t limit,
                      std::chrono::seconds patience) {
  ChildOutput output;
  Pipe pipe;
  pid_t child = 0;
  if (!pipe.open()) {
    output.problem = std::string("no pipe could be opened: ") + std::strerror(errno);
    return output;
  }
  if (const int error = spawn(words, folder, pipe.write_end, child); error != 0) {
    output.problem = std::strerror(error);
    return output;
  }
  pipe.close_write_end();
  output.problem = collect(pipe.read_end, limit, Clock::now() + patience, output.text);
  if (!output.problem.empty()) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (output.problem.empty() && WIFEXITED(status) && WEXITSTATUS(status) == 127) output.problem = "it was not found";
  if (!output.problem.empty()) output.text.clear();
  return output;
}

}  // namespace rad::readers
