#include "cli/judge_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <numeric>
#include <thread>

#include "batch/digest.h"
#include "batch/result_cache.h"
#include "batch/tool_identity.h"
#include "cli/judge.h"
#include "cli/threads.h"
#include "readers/file_bytes.h"
#include "report/input_record.h"
#include "report/text_layout.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

// Whether the result is one to come back to: complete, and of a file that was there.
bool is_worth_keeping(const report::InputReport& input) {
  return input.read && input.result.incomplete.empty() && input.result.refusal.empty();
}

class FileJudge {
 public:
  explicit FileJudge(const RunPlan& plan) : plan_(plan) {
    if (!plan.cache) return;
    cache_.emplace(*plan.cache);
    tool_ = batch::tool_identity();
  }

  [[nodiscard]] report::InputReport judged(const FilePlan& file) const {
    std::vector<fs::path> companions;
    return judged(file, companions);
  }

  /// The same as a record, from the cache where it can be.
  [[nodiscard]] std::string record(const FilePlan& file) const {
    const std::optional<std::string> key = key_of(file);
    if (key) {
      if (std::optional<std::string> kept = cache_->find(*key)) return *std::move(kept);
    }
    std::vector<fs::path> companions;
    const report::InputReport input = judged(file, companions);
    std::string record = report::record_of(input);
    if (key && is_worth_keeping(input)) cache_->keep(*key, record, companions);
    return record;
  }

  void tidy() const {
    if (cache_) cache_->trim();
  }

 private:
  static report::InputReport judged(const FilePlan& file, std::vector<fs::path>& companions) {
    Model model = read_model(file.path, file.model);
    companions = std::move(model.content.companions);
    judge(model, file.lint);
    return std::move(model.report);
  }

  [[nodiscard]] std::optional<std::string> key_of(const FilePlan& file) const {
    if (!cache_) return std::nullopt;
    readers::FileBytes content;
    if (!content.open(file.path, UINT64_MAX, readers::FileKind::Regular).empty()) return std::nullopt;
    return batch::Digest().add(tool_).add(settings_text(file)).add(content.bytes()).hex();
  }

  const RunPlan& plan_;
  std::optional<batch::ResultCache> cache_;
  std::string tool_;
};

std::string how_it_died(int signal) {
  if (signal == 0) return "the process that judged it left before it was done";
  const char* name = ::strsignal(signal);
  return fmt::format("the process that judged it was ended by signal {} ({}){}", signal,
                     name == nullptr ? "unknown" : name,
                     signal == 9 ? ", as the system does when memory runs out" : "");
}

std::string why_not_judged(const batch::TaskOutcome& outcome, const batch::TaskLimits& limits) {
  switch (outcome.ending) {
    case batch::Ending::TimeLimit:
      return fmt::format("the time limit of {} s was reached", limits.seconds.value_or(0));
    case batch::Ending::OutOfMemory:
      if (limits.bytes) return fmt::format("the memory limit of {} was reached", report::byte_size(*limits.bytes));
      return "judging it takes more memory than there is";
    case batch::Ending::Failed:
      return "judging it failed: " + outcome.bytes;
    case batch::Ending::Died:
      return how_it_died(outcome.signal);
    case batch::Ending::Done:
      break;
  }
  return "its result was lost on the way";
}

report::InputReport input_of(const FilePlan& file, const batch::TaskOutcome& outcome, const batch::TaskLimits& limits) {
  if (outcome.ending == batch::Ending::Done) {
    if (std::optional<report::InputReport> input = report::input_of_record(outcome.bytes)) return *std::move(input);
  }
  return undecided(file.path, why_not_judged(outcome, limits), file.lint);
}

std::size_t thread_count(std::size_t jobs) {
  return jobs > 0 ? jobs : std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
}

// Large files first: the last to be taken up is then a small one, and nobody waits for it.
std::vector<std::size_t> by_size(const std::vector<FilePlan>& files) {
  std::vector<std::uintmax_t> sizes;
  for (const FilePlan& file : files) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file.path, error);
    sizes.push_back(error ? 0 : size);
  }
  std::vector<std::size_t> order(files.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  return order;
}

using Ended = std::function<void(std::size_t, const std::string&)>;

report::InputReport judge_here(const FileJudge& judge, const FilePlan& file, const RunPlan& plan) {
  batch::TaskOutcome outcome;
  try {
    if (!plan.cache) return judge.judged(file);
    outcome = {batch::Ending::Done, judge.record(file), 0};
  } catch (const std::bad_alloc&) {
    outcome.ending = batch::Ending::OutOfMemory;
  }
  return input_of(file, outcome, {});
}

JudgedFiles judge_all_here(const FileJudge& judge, const RunPlan& plan, const Ended& ended) {
  const Threads threads(plan.jobs);
  JudgedFiles judged;
  for (const FilePlan& file : plan.files) {
    ended(judged.inputs.size(), file.path);
    judged.inputs.push_back(judge_here(judge, file, plan));
  }
  return judged;
}

JudgedFiles judge_in_workers(const FileJudge& judge, const RunPlan& plan, const Ended& ended,
                             const std::function<bool()>& stopped) {
  JudgedFiles judged;
  judged.inputs.resize(plan.files.size());
  std::size_t done = 0;
  batch::Pool pool;
  pool.threads = thread_count(plan.jobs);
  pool.workers = std::min(pool.threads, plan.files.size());
  pool.limits = plan.limits;
  pool.work = [&](std::size_t task, std::size_t threads) {
    const Threads share(threads);
    return judge.record(plan.files[task]);
  };
  pool.ended = [&](std::size_t task, const batch::TaskOutcome& outcome) {
    judged.inputs[task] = input_of(plan.files[task], outcome, plan.limits);
    ended(++done, plan.files[task].path);
  };
  pool.stopped = stopped;
  judged.stopped = !batch::run_tasks(by_size(plan.files), pool);
  if (judged.stopped) judged.inputs.clear();
  return judged;
}

}  // namespace

JudgedFiles judge_files(const RunPlan& plan, const Ended& ended, const std::function<bool()>& stopped) {
  const FileJudge judge(plan);
  const bool limited = plan.limits.seconds || plan.limits.bytes;
  const bool here = !plan.workers || (plan.files.size() < 2 && !limited);
  JudgedFiles judged = here ? judge_all_here(judge, plan, ended) : judge_in_workers(judge, plan, ended, stopped);
  judge.tidy();
  return judged;
}

}  // namespace rad::cli
