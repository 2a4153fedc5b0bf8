// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/known_failures_update.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonogo::oracle {
namespace {

// "0-357" of 0, 1, 2, 3, 5, 7.
std::string class_of(const std::string& digits) {
  std::string text;
  for (std::size_t i = 0; i < digits.size();) {
    std::size_t end = i + 1;
    while (end < digits.size() && digits[end] == digits[end - 1] + 1) ++end;
    text += digits[i];
    if (end - i > 2) text += '-';
    if (end - i > 1) text += digits[end - 1];
    i = end;
  }
  return text;
}

// What the case of an xfail line departs by.
Verdict departure_of(const CaseHead& head) {
  Verdict verdict;
  verdict.kind = verdict_kind(head.departure).value_or(VerdictKind::oracle_error);
  verdict.deviation_exact = head.deviation;
  verdict.got = head.got;
  return verdict;
}

// The blocks of a program behind one another, as the key `program` has them; nothing for bytes
// that a TOML text may not have.
std::string in_one_line(const std::string& program) {
  std::string text;
  for (const char c : program) {
    if ((static_cast<unsigned char>(c) & 0x80U) != 0) return {};
    const bool ends = c == '\n' || c == '\r';
    if (!ends) {
      text += c;
    } else if (!text.empty() && !text.ends_with(" | ")) {
      text += " | ";
    }
  }
  if (text.ends_with(" | ")) text.resize(text.size() - 3);
  return text;
}

}  // namespace

std::vector<std::string> globs_of_ids(std::vector<std::string> ids) {
  std::ranges::sort(ids);
  std::vector<std::string> globs;
  for (std::size_t i = 0; i < ids.size();) {
    const std::string stem = ids[i].substr(0, ids[i].size() - 1);
    std::string digits;
    std::size_t end = i;
    while (end < ids.size() && ids[end].size() == ids[i].size() && ids[end].starts_with(stem) &&
           ids[end].back() >= '0' && ids[end].back() <= '9') {
      digits += ids[end++].back();
    }
    if (digits.size() < 2) {
      globs.push_back(ids[i++]);
      continue;
    }
    globs.push_back(fmt::format("{}[{}]", stem, class_of(digits)));
    i = end;
  }
  return globs;
}

KnownFailuresUpdate::KnownFailuresUpdate(std::vector<KnownCause> before)
    : before_(std::move(before)) {
  for (std::size_t i = 0; i < before_.size(); ++i) {
    for (std::size_t k = 0; k < before_[i].failures.size(); ++k) {
      for (KnownFailure& entry : entries_of({{before_[i].reason, {}, {before_[i].failures[k]}}})) {
        entries_.emplace_back(Place(i, k), std::move(entry));
      }
    }
  }
}

void KnownFailuresUpdate::add(const CaseFacts& facts, VerdictKind kind, const Finding* finding) {
  if (kind == VerdictKind::xfail) {
    judged_.insert(facts.head.id);
    const Verdict departure = departure_of(facts.head);
    const auto own = std::ranges::find_if(entries_, [&](const auto& one) {
      return one.second.is(departure) && one.second.covers(facts.head.id);
    });
    if (own != entries_.end()) explained_.emplace(facts.head.id, own->first);
    return;
  }
  if (!is_judged(kind)) return;
  judged_.insert(facts.head.id);
  if (finding == nullptr || kind == VerdictKind::xpass) return;
  if (kind == VerdictKind::state_leak) {
    ++unsteady_;
  } else {
    New& fresh = new_[finding->key];
    fresh.reason = fmt::format("Not looked at yet: {}.", finding->text());
    fresh.finding = finding->number;
    fresh.cases[{kind, facts.head.deviation}].push_back(facts.head.id);
  }
}

// The globs of a failure without the cases that do not fail so any more. A glob of which all is
// true stays as it is written.
std::vector<std::string> KnownFailuresUpdate::kept(const Place& place,
                                                   const std::vector<std::string>& corpus,
                                                   std::size_t& pruned) const {
  std::vector<std::string> globs;
  std::vector<std::string> single;
  for (const auto& [at, entry] : entries_) {
    if (at != place) continue;
    std::vector<std::string> ids;
    std::size_t gone = 0;
    for (const std::string& id : corpus) {
      if (!entry.covers(id)) continue;
      const auto known = explained_.find(id);
      const bool is_so = known != explained_.end() && known->second == place;
      // What fails now and then may pass.
      const bool stays = is_so || entry.flaky || !judged_.contains(id);
      stays ? ids.push_back(id) : void(++gone);
    }
    pruned += gone;
    if (gone == 0 && !ids.empty() && ids.size() <= kMostCasesOfAGlob) {
      globs.push_back(entry.cases);
    } else {
      single.insert(single.end(), ids.begin(), ids.end());
    }
  }
  for (std::string& glob : globs_of_ids(std::move(single))) globs.push_back(std::move(glob));
  return globs;
}

KnownFailuresUpdate::Result KnownFailuresUpdate::result(
    const std::vector<std::string>& corpus,
    const std::map<std::size_t, std::string>& smallest) const {
  Result result;
  result.unsteady = unsteady_;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    KnownCause cause{before_[i].reason, before_[i].program, {}};
    for (std::size_t k = 0; k < before_[i].failures.size(); ++k) {
      KnownCause::Failure failure = before_[i].failures[k];
      failure.cases = kept({i, k}, corpus, result.pruned);
      if (!failure.cases.empty()) cause.failures.push_back(std::move(failure));
    }
    if (!cause.failures.empty()) result.causes.push_back(std::move(cause));
  }
  for (const auto& [key, fresh] : new_) {
    const auto program = smallest.find(fresh.finding);
    KnownCause cause{
        fresh.reason, program == smallest.end() ? std::string() : in_one_line(program->second), {}};
    for (const auto& [how, ids] : fresh.cases) {
      result.added += ids.size();
      cause.failures.push_back({how.first, how.second, {}, {}, globs_of_ids(ids)});
    }
    // A run of another part may have begun the same cause.
    const auto same = std::ranges::find(result.causes, cause.reason, &KnownCause::reason);
    if (same == result.causes.end()) {
      result.causes.push_back(std::move(cause));
    } else {
      std::ranges::move(cause.failures, std::back_inserter(same->failures));
    }
  }
  return result;
}

}  // namespace gonogo::oracle
