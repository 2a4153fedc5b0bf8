// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/record_log.hpp"

#include "reference/expander.hpp"

namespace gonogo::oracle {

using reference::Record;

void RecordLog::add_own(std::size_t item, const Record* named) {
  Run* run = parts_.empty() ? nullptr : std::get_if<Run>(&parts_.back());
  if (run == nullptr || run->last + 1 != item) {
    run = &std::get<Run>(parts_.emplace_back(Run{item, item, std::nullopt}));
  }
  run->last = item;
  run->named.reset();
  if (named != nullptr) run->named = *named;
}

namespace {

// The items of the reference by their numbers, in ascending order.
class Items {
 public:
  Items(const reference::Profile& profile, const ProgramText& program)
      : input_(program), expander_(profile, input_.lines, reference::OpenPaths::judged) {}

  const Record& record(std::size_t number) {
    const reference::Item* item = nullptr;
    for (; count_ < number; ++count_) item = expander_.next();
    return std::get<Record>(*item);
  }

 private:
  ProgramInput input_;
  reference::Expander expander_;
  std::size_t count_ = 0;
};

}  // namespace

void RecordLog::replay(const reference::Profile& profile, const ProgramText& program,
                       const std::function<void(const Record&)>& take) const {
  std::optional<Items> items;
  for (const auto& part : parts_) {
    if (const Record* record = std::get_if<Record>(&part)) {
      take(*record);
      continue;
    }
    if (!items) items.emplace(profile, program);
    const Run& run = std::get<Run>(part);
    for (std::size_t i = run.first; i < run.last; ++i) take(items->record(i));
    if (run.named) {
      take(*run.named);
      continue;
    }
    Record last = items->record(run.last);
    last.clause = reference::kNoClause;
    take(last);
  }
}

}  // namespace gonogo::oracle
