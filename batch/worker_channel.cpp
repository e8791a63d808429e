#include "batch/worker_channel.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace rad::batch {

namespace {

constexpr std::size_t kHeadBytes = 1 + sizeof(std::uint64_t);

bool send_all(int socket, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = ::send(socket, data, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    data += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

}  // namespace

bool send_task(int socket, const TaskMessage& message) {
  std::array<char, sizeof message> bytes;
  std::memcpy(bytes.data(), &message, sizeof message);
  return send_all(socket, bytes.data(), bytes.size());
}

std::optional<TaskMessage> receive_task(int socket) {
  std::array<char, sizeof(TaskMessage)> bytes;
  std::size_t have = 0;
  while (have < bytes.size()) {
    const ssize_t count = ::recv(socket, bytes.data() + have, bytes.size() - have, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    have += static_cast<std::size_t>(count);
  }
  TaskMessage message;
  std::memcpy(&message, bytes.data(), sizeof message);
  return message;
}

bool send_answer(int socket, char ending, std::string_view bytes) {
  std::array<char, kHeadBytes> head;
  const std::uint64_t size = bytes.size();
  head[0] = ending;
  std::memcpy(head.data() + 1, &size, sizeof size);
  return send_all(socket, head.data(), head.size()) && send_all(socket, bytes.data(), bytes.size());
}

bool AnswerBuffer::read_from(int socket) {
  std::array<char, 1U << 16U> chunk;
  const ssize_t count = ::recv(socket, chunk.data(), chunk.size(), MSG_DONTWAIT);
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  bytes_.append(chunk.data(), static_cast<std::size_t>(count));
  return count > 0;
}

std::uint64_t AnswerBuffer::size() const {
  std::uint64_t size = 0;
  std::memcpy(&size, bytes_.data() + 1, sizeof size);
  return size;
}

bool AnswerBuffer::complete() const { return bytes_.size() >= kHeadBytes && bytes_.size() - kHeadBytes >= size(); }

std::string AnswerBuffer::take() {
  std::string answer = bytes_.substr(kHeadBytes);
  bytes_.clear();
  return answer;
}

}  // namespace rad::batch
