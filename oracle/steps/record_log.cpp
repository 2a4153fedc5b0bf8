// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/record_log.hpp"

#include "reference/expander.hpp"

namespace gonogo::oracle {

using reference::Record;

void RecordLog::add_own(const std::shared_ptr<const reference::Profile>& profile, std::size_t item,
                        const Record* named) {
  Run* run = parts_.empty() ? nullptr : std::get_if<Run>(&parts_.back());
  if (run == nullptr || run->last + 1 != item || run->profile != profile) {
    run = &std::get<Run>(parts_.emplace_back(Run{profile, item, item, std::nullopt}));
  }
  run->last = item;
  run->named.reset();
  if (named != nullptr) run->named = *named;
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

void RecordLog::replay(const ProgramText& program,
                       const std::function<bool(const Record&)>& take) const {
  std::optional<Items> items;
  for (const auto& part : parts_) {
    if (const Record* record = std::get_if<Record>(&part)) {
      if (!take(*record)) return;
      continue;
    }
    const Run& run = std::get<Run>(part);
    if (!items || items->profile() != run.profile.get()) items.emplace(run.profile, program);
    for (std::size_t i = run.first; i < run.last; ++i) {
      if (!take(items->record(i))) return;
    }
    Record last = run.named ? *run.named : items->record(run.last);
    if (!run.named) last.clause = reference::kNoClause;
    if (!take(last)) return;
  }
}

}  // namespace gonogo::oracle
