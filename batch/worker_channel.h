// What a pool and a worker say to each other over a socket.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rad::batch {

struct TaskMessage {
  std::uint64_t task = 0;
  std::uint64_t threads = 1;
};

/// Blocking. False where the other side is gone.
bool send_task(int socket, const TaskMessage& message);
std::optional<TaskMessage> receive_task(int socket);

/// The answer to a task: how it ended, a letter, and bytes.
bool send_answer(int socket, char ending, std::string_view bytes);

/// Collects an answer that comes in pieces.
class AnswerBuffer {
 public:
  /// Reads what there is. False at the end of the stream.
  bool read_from(int socket);
  [[nodiscard]] bool complete() const;
  [[nodiscard]] char ending() const { return bytes_.front(); }
  std::string take();

 private:
  [[nodiscard]] std::uint64_t size() const;
  std::string bytes_;
};

}  // namespace rad::batch
