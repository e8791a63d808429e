#include "batch/worker_pool.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <new>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rad::batch {
namespace {

using Outcomes = std::map<std::size_t, TaskOutcome>;

struct Ran {
  Outcomes outcomes;
  bool to_the_end = false;
};

Ran run(std::size_t count, Pool pool) {
  Ran ran;
  std::vector<std::size_t> tasks(count);
  std::iota(tasks.begin(), tasks.end(), std::size_t{0});
  pool.ended = [&](std::size_t task, TaskOutcome outcome) {
    EXPECT_TRUE(ran.outcomes.emplace(task, std::move(outcome)).second) << task;
  };
  ran.to_the_end = run_tasks(tasks, pool);
  return ran;
}

TEST(WorkerPool, EveryTaskIsDoneOnce) {
  Pool pool;
  pool.workers = 3;
  pool.work = [](std::size_t task, std::size_t) { return std::string(task * 1000, 'x'); };
  const Ran ran = run(40, pool);
  EXPECT_TRUE(ran.to_the_end);
  ASSERT_EQ(ran.outcomes.size(), 40U);
  for (const auto& [task, outcome] : ran.outcomes) {
    EXPECT_EQ(outcome.ending, Ending::Done);
    EXPECT_EQ(outcome.bytes.size(), task * 1000);
  }
}

TEST(WorkerPool, NothingToDo) {
  Pool pool;
  pool.work = [](std::size_t, std::size_t) { return std::string(); };
  EXPECT_TRUE(run(0, pool).to_the_end);
}

TEST(WorkerPool, WorkIsDoneInOtherProcesses) {
  Pool pool;
  pool.workers = 2;
  pool.work = [](std::size_t, std::size_t) { return std::to_string(::getpid()); };
  for (const auto& [task, outcome] : run(4, pool).outcomes) EXPECT_NE(outcome.bytes, std::to_string(::getpid()));
}

TEST(WorkerPool, ThreadsAreSharedOut) {
  Pool pool;
  pool.workers = 2;
  pool.threads = 8;
  pool.work = [](std::size_t, std::size_t threads) { return std::to_string(threads); };
  EXPECT_EQ(run(1, pool).outcomes.at(0).bytes, "8");
  EXPECT_EQ(run(6, pool).outcomes.at(0).bytes, "4");
}

TEST(WorkerPool, ACrashCostsOneTask) {
  Pool pool;
  pool.workers = 2;
  pool.work = [](std::size_t task, std::size_t) {
    if (task == 3) ::raise(SIGKILL);
    if (task == 5) ::_exit(7);
    return std::string("fine");
  };
  const Ran ran = run(9, pool);
  ASSERT_EQ(ran.outcomes.size(), 9U);
  EXPECT_EQ(ran.outcomes.at(3).ending, Ending::Died);
  EXPECT_EQ(ran.outcomes.at(3).signal, SIGKILL);
  EXPECT_EQ(ran.outcomes.at(5).ending, Ending::Died);
  EXPECT_EQ(ran.outcomes.at(5).signal, 0);
  for (const std::size_t task : {0, 1, 2, 4, 6, 7, 8}) EXPECT_EQ(ran.outcomes.at(task).bytes, "fine") << task;
}

TEST(WorkerPool, WhatIsThrownIsTold) {
  Pool pool;
  pool.work = [](std::size_t task, std::size_t) -> std::string {
    if (task == 0) throw std::runtime_error("no luck");
    if (task == 1) throw std::bad_alloc();
    return "fine";
  };
  const Ran ran = run(3, pool);
  EXPECT_EQ(ran.outcomes.at(0).ending, Ending::Failed);
  EXPECT_EQ(ran.outcomes.at(0).bytes, "no luck");
  EXPECT_EQ(ran.outcomes.at(1).ending, Ending::OutOfMemory);
  EXPECT_EQ(ran.outcomes.at(2).bytes, "fine");
}

TEST(WorkerPool, TimeLimitEndsATaskAndNoOther) {
  Pool pool;
  pool.workers = 2;
  pool.limits.seconds = 0.2;
  pool.work = [](std::size_t task, std::size_t) {
    if (task == 1) std::this_thread::sleep_for(std::chrono::hours(1));
    return std::string("fine");
  };
  const Ran ran = run(5, pool);
  EXPECT_TRUE(ran.to_the_end);
  EXPECT_EQ(ran.outcomes.at(1).ending, Ending::TimeLimit);
  for (const std::size_t task : {0, 2, 3, 4}) EXPECT_EQ(ran.outcomes.at(task).ending, Ending::Done) << task;
}

// Under the address sanitizer memory does not come from where the limit is held.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(WorkerPool, MemoryLimitEndsATaskAndNoOther) {
  Pool pool;
  pool.limits.bytes = std::uint64_t{256} << 20;
  pool.work = [](std::size_t task, std::size_t) {
    const std::vector<char> taken(task == 1 ? std::size_t{1} << 30 : std::size_t{100} << 20, 'x');
    return std::string(1, taken[taken.size() / 2]);
  };
  const Ran ran = run(4, pool);
  EXPECT_EQ(ran.outcomes.at(1).ending, Ending::OutOfMemory);
  for (const std::size_t task : {0, 2, 3}) EXPECT_EQ(ran.outcomes.at(task).bytes, "x") << task;
}
#endif

TEST(WorkerPool, StopsWhenAsked) {
  Pool pool;
  pool.workers = 2;
  pool.work = [](std::size_t, std::size_t) -> std::string {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return {};
  };
  int asked = 0;
  pool.stopped = [&] { return ++asked > 2; };
  const Ran ran = run(4, pool);
  EXPECT_FALSE(ran.to_the_end);
  EXPECT_TRUE(ran.outcomes.empty());
}

}  // namespace
}  // namespace rad::batch
