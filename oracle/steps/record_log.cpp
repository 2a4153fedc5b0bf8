// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/record_log.hpp"

#include <utility>

#include "oracle/region/constants.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

using reference::Record;

void RecordLog::add_own(const std::shared_ptr<const reference::Profile>& profile, std::size_t item,
                        const Record* named) {
  Run* run = parts_.empty() ? nullptr : std::get_if<Run>(&parts_.back());
  if (run == nullptr || run->last + 1 != item || run->profile != profile) {
    run = &std::get<Run>(parts_.emplace_back(Run{profile, item, item, std::nullopt, {}}));
  }
  run->last = item;
  run->named.reset();
  if (named == nullptr) return;
  run->named = *named;
  if (kept_ < kMostParts && run->first + run->kept.size() == item) {
    run->kept.push_back(*named);
    ++kept_;
  }
}

namespace {

// The items of the reference by their numbers, in ascending order.
class Items {
 public:
  Items(std::shared_ptr<const reference::Profile> profile, const ProgramText& program)
      : profile_(std::move(profile)),
        input_(program),
        expander_(*profile_, input_.lines, reference::OpenPaths::judged) {}

  const reference::Profile* profile() const { return profile_.get(); }
  const Record& record(std::size_t number) {
    const reference::Item* item = nullptr;
    for (; count_ < number; ++count_) item = expander_.next();
    return std::get<Record>(*item);
  }

 private:
  std::shared_ptr<const reference::Profile> profile_;
  ProgramInput input_;
  reference::Expander expander_;
  std::size_t count_ = 0;
};

}  // namespace

std::size_t RecordLog::own_at_beginning() const {
  const Run* first = parts_.empty() ? nullptr : std::get_if<Run>(&parts_.front());
  return first != nullptr && first->first == 1 ? first->last : 0;
}

void RecordLog::replay(const ProgramText& program, const std::function<bool(const Record&)>& take,
                       std::size_t from) const {
  std::optional<Items> items;
  for (const auto& part : parts_) {
    if (const Record* record = std::get_if<Record>(&part)) {
      if (!take(*record)) return;
      continue;
    }
    const Run& run = std::get<Run>(part);
    const auto own = [&](std::size_t item) -> const Record& {
      if (item - run.first < run.kept.size()) return run.kept[item - run.first];
      if (!items || items->profile() != run.profile.get()) items.emplace(run.profile, program);
      return items->record(item);
    };
    const std::size_t left_out = std::exchange(from, 0);
    if (left_out >= run.last) continue;
    for (std::size_t i = run.first + left_out; i < run.last; ++i) {
      if (!take(own(i))) return;
    }
    Record last = run.named ? *run.named : own(run.last);
    if (!run.named) last.clause = reference::kNoClause;
    if (!take(last)) return;
  }
}

}  // namespace gonogo::oracle
