#include "scene/read_issue.h"

#include <algorithm>
#include <utility>

namespace rad::scene {

void ReadIssues::add(ReadIssue issue) {
  const auto same_kind = [&](const ReadIssue& other) { return other.kind == issue.kind; };
  const auto kept = std::count_if(issues_.begin(), issues_.end(), same_kind);
  if (static_cast<std::size_t>(kept) < kKept) {
    issues_.push_back(std::move(issue));
    return;
  }
  std::find_if(issues_.rbegin(), issues_.rend(), same_kind)->count += issue.count;
}

void ReadIssues::add_unsupported(std::string what, IssuePlace place) {
  for (ReadIssue& issue : issues_) {
    if (issue.kind == ReadIssueKind::UnsupportedContent && issue.what == what) {
      ++issue.count;
      return;
    }
  }
  add({ReadIssueKind::UnsupportedContent, std::move(what), std::move(place), 1});
}

bool ReadIssues::any(ReadIssueKind kind) const {
  return std::any_of(issues_.begin(), issues_.end(), [kind](const ReadIssue& issue) { return issue.kind == kind; });
}

}  // namespace rad::scene
