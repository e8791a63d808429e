#include "readers/obj_waivers.h"

#include <limits>
#include <utility>

#include "readers/waiver_comment.h"

namespace rad::readers {

void ObjWaivers::read_comment(std::string_view comment, std::uint64_t line) {
  auto read = waiver_of_comment(comment);
  if (!read) return;
  read->waiver.place.line = line;
  if (!read->whole_file) {
    // Until it is known what it speaks of it covers no line: those count from 1.
    read->waiver.scope = scene::WaiverScope::Records;
    waiting_.push_back(waivers_.size());
  }
  waivers_.push_back(std::move(read->waiver));
}

void ObjWaivers::read_comment_behind_face(std::string_view comment, std::uint64_t line) {
  auto read = waiver_of_comment(comment);
  if (!read) return;
  scene::Waiver& waiver = waivers_.emplace_back(std::move(read->waiver));
  waiver.place.line = line;
  if (!read->whole_file) waiver.scope = scene::WaiverScope::Records;
  waiver.first = waiver.last = line;
}

void ObjWaivers::cover_face(std::uint64_t line) {
  for (const std::size_t index : waiting_) waivers_[index].first = waivers_[index].last = line;
  waiting_.clear();
}

void ObjWaivers::block(Block block, std::uint64_t line) {
  std::erase_if(open_, [&](const Open& open) {
    const bool ends = block == Block::Object || open.block == Block::Group;
    if (ends) waivers_[open.waiver].last = line - 1;
    return ends;
  });
  for (const std::size_t index : waiting_) {
    waivers_[index].first = line;
    waivers_[index].last = std::numeric_limits<std::uint64_t>::max();
    open_.push_back({index, block});
  }
  waiting_.clear();
}

std::vector<scene::Waiver> ObjWaivers::take() { return std::move(waivers_); }

}  // namespace rad::readers
