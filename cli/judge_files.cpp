#include "cli/judge_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <thread>

#include "batch/file_state.h"
#include "batch/result_cache.h"
#include "batch/tool_identity.h"
#include "cli/judge.h"
#include "cli/threads.h"
#include "report/input_record.h"
#include "report/text_layout.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

// Whether the result is one to come back to: complete, and of a file that was there.
bool is_worth_keeping(const report::InputReport& input) {
  return input.read && input.result.incomplete.empty() && input.result.refusal.empty();
}

// What a worker answers: a record alone, or an entry for the cache that holds one.
constexpr char kRecord = 'r', kEntry = 'e';

class FileJudge {
 public:
  explicit FileJudge(const RunPlan& plan) : detail_(plan.detail) {
    if (plan.cache) cache_.emplace(*plan.cache, batch::tool_identity());
  }

  static report::InputReport judged(const FilePlan& file) {
    std::vector<fs::path> companions;
    return judged(file, companions);
  }

  /// Before kept() is asked from several threads.
  void open(const std::vector<FilePlan>& files) {
    if (!cache_) return;
    for (const FilePlan& file : files) cache_->open(file.path);
  }

  /// Of an earlier run; nothing where there is none that still holds.
  std::optional<report::InputReport> kept(const FilePlan& file) {
    try {
      const auto record = cache_ ? cache_->find(file.path, file.settings->digest) : std::nullopt;
      return record ? report::input_of_record(*record, detail_) : std::nullopt;
    } catch (const std::bad_alloc&) {
      return std::nullopt;
    }
  }

  /// Judges a file and says so in bytes that take() understands.
  [[nodiscard]] std::string answer(const FilePlan& file) const {
    const auto before = cache_ ? batch::state_of(file.path) : std::nullopt;
    std::vector<fs::path> companions;
    report::InputReport input = judged(file, companions);
    if (!before || !is_worth_keeping(input) || batch::stamp_of(file.path) != before->stamp) {
      return kRecord + report::record_of(std::move(input));
    }
    input.result.timings.clear();  // whoever asks for them does without a cache
    return kEntry + batch::entry_of(*before, report::record_of(std::move(input)), companions);
  }

  /// The report in an answer; keeps it for later runs.
  std::optional<report::InputReport> take(const FilePlan& file, std::string_view answer) {
    const std::string_view body = answer.substr(1);
    if (answer.front() == kRecord) return report::input_of_record(body, detail_);
    auto input = report::input_of_record(batch::result_of(body), detail_);
    cache_->keep(file.path, file.settings->digest, std::string(body));
    return input;
  }

  void save() {
    if (cache_) cache_->save();
  }

 private:
  static report::InputReport judged(const FilePlan& file, std::vector<fs::path>& companions) {
    Model model = read_model(file.path, file.settings->model);
    judge_with_waivers(model, file.settings->lint);
    companions = std::move(model.content.companions);
    return std::move(model.report);
  }

  report::Detail detail_;
  std::optional<batch::ResultCache> cache_;
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

report::InputReport input_of(FileJudge& judge, const FilePlan& file, const batch::TaskOutcome& outcome,
                             const batch::TaskLimits& limits) {
  if (outcome.ending == batch::Ending::Done) {
    if (auto input = judge.take(file, outcome.bytes)) return *std::move(input);
  }
  return undecided(file.path, why_not_judged(outcome, limits), file.settings->lint);
}

std::size_t thread_count(std::size_t jobs) {
  return jobs > 0 ? jobs : std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
}

// Large files first: the last to be taken up is then a small one, and nobody waits for it.
std::vector<std::size_t> by_size(const std::vector<FilePlan>& files, std::vector<std::size_t> order) {
  std::vector<std::uintmax_t> sizes(files.size());
  for (const std::size_t index : order) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(files[index].path, error);
    sizes[index] = error ? 0 : size;
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  return order;
}

using Ended = std::function<void(std::size_t, const std::string&)>;

// A thread is not worth its start for fewer.
constexpr std::size_t kFilesOfThread = 64;

/// One run over the files of a plan.
class Run {
 public:
  Run(const RunPlan& plan, const Ended& ended, const std::function<bool()>& stopped)
      : plan_(plan), ended_(ended), stopped_(stopped), judge_(plan) {
    judged_.inputs.resize(plan.files.size());
  }

  JudgedFiles run() {
    take_kept();
    const bool limited = plan_.limits.seconds || plan_.limits.bytes;
    const bool here = !plan_.workers || (plan_.files.size() < 2 && !limited);
    if (here) {
      judge_here();
    } else {
      judge_in_workers();
    }
    judge_.save();
    for (std::size_t i = 0; i < judged_.inputs.size(); ++i) {
      judged_.inputs[i].configuration = plan_.files[i].settings->configuration;
    }
    return std::move(judged_);
  }

 private:
  // Threads of its own, which have ended before a worker process is made.
  void take_kept() {
    judge_.open(plan_.files);
    std::vector<char> found(plan_.files.size());
    const std::size_t share = std::max(kFilesOfThread, plan_.files.size() / thread_count(plan_.jobs) + 1);
    const auto take = [&](std::size_t from) {
      for (std::size_t i = from; i < std::min(from + share, found.size()); ++i) {
        auto input = judge_.kept(plan_.files[i]);
        found[i] = input.has_value() ? 1 : 0;
        if (input) judged_.inputs[i] = *std::move(input);
      }
    };
    {
      std::vector<std::jthread> threads;
      for (std::size_t from = share; from < found.size(); from += share) threads.emplace_back(take, from);
      take(0);
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i] == 0) missing_.push_back(i);
    }
    done_ = found.size() - missing_.size();
  }

  report::InputReport judged_here(const FilePlan& file) {
    batch::TaskOutcome outcome;
    try {
      if (!plan_.cache) return FileJudge::judged(file);
      outcome = {batch::Ending::Done, judge_.answer(file), 0};
    } catch (const std::bad_alloc&) {
      outcome.ending = batch::Ending::OutOfMemory;
    }
    return input_of(judge_, file, outcome, {});
  }

  void judge_here() {
    const Threads threads(plan_.jobs);
    for (const std::size_t index : missing_) {
      ended_(done_++, plan_.files[index].path);
      judged_.inputs[index] = judged_here(plan_.files[index]);
    }
  }

  void judge_in_workers() {
    batch::Pool pool;
    pool.threads = thread_count(plan_.jobs);
    pool.workers = std::min(pool.threads, missing_.size());
    pool.limits = plan_.limits;
    pool.work = [&](std::size_t task, std::size_t threads) {
      const Threads share(threads);
      return judge_.answer(plan_.files[task]);
    };
    pool.ended = [&](std::size_t task, const batch::TaskOutcome& outcome) {
      judged_.inputs[task] = input_of(judge_, plan_.files[task], outcome, plan_.limits);
      ended_(++done_, plan_.files[task].path);
    };
    pool.stopped = stopped_;
    judged_.stopped = !batch::run_tasks(by_size(plan_.files, missing_), pool);
    if (judged_.stopped) judged_.inputs.clear();
  }

  const RunPlan& plan_;
  const Ended& ended_;
  const std::function<bool()>& stopped_;
  FileJudge judge_;
  JudgedFiles judged_;
  std::vector<std::size_t> missing_;  ///< of which no kept result holds
  std::size_t done_ = 0;
};

}  // namespace

JudgedFiles judge_files(const RunPlan& plan, const Ended& ended, const std::function<bool()>& stopped) {
  return Run(plan, ended, stopped).run();
}

}  // namespace rad::cli
