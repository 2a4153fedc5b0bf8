// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>

#include "campaign/encoding.hpp"
#include "oracle/judge/cycle_time.hpp"
#include "oracle/records/trace_reader.hpp"
#include "publish/report/case_detail.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle::report {
namespace {

struct ReferenceTimes {
  CycleTime whole;
  CycleTime to_departure;
};

// Nothing: more than is drawn, or positions get other names, in which no record of a subject says
// how far it goes.
std::optional<ReferenceTimes> reference_times(const reference::Profile& profile,
                                              std::string_view program,
                                              std::optional<std::size_t> wanted) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  ReferenceTimes times{CycleTime(profile.initial.at), CycleTime(profile.initial.at)};
  std::size_t place = 0;
  while (const reference::Item* item = expander.next()) {
    if (std::holds_alternative<reference::Renaming>(*item)) return std::nullopt;
    const auto* record = std::get_if<reference::Record>(item);
    if (record == nullptr) continue;
    if (place >= kMaxRecords) return std::nullopt;
    times.whole.take(*record);
    if (wanted && place <= *wanted) times.to_departure.take(*record);
    ++place;
  }
  return times;
}

std::optional<CycleTime> subject_time(const reference::Profile& profile, const Json& trace,
                                      std::optional<std::size_t> last) {
  if (trace.size() >= kMaxRecords) return std::nullopt;
  CycleTime time(profile.initial.at);
  TraceReader reader;
  for (std::size_t i = 0; i < trace.size() && (!last || i <= *last); ++i) {
    const TraceLine line = reader.read(dump(trace[i]));
    const auto* record = std::get_if<reference::Record>(&line);
    if (record == nullptr) break;
    time.take(*record);
  }
  return time;
}

}  // namespace

Json case_times(const reference::Profile& profile, std::string_view program, const Json& trace,
                const Parting& parting) {
  try {
    const bool is_known = parting.wanted && parting.record;
    const auto want = reference_times(profile, program, parting.wanted);
    const auto got = subject_time(profile, trace, is_known ? parting.record : std::nullopt);
    if (!want || !got) return nullptr;
    const auto whole = parts_of(want->whole);
    const auto due = parts_of(want->to_departure);
    const auto shown = parts_of(*got);
    Json rows = Json::array();
    for (std::size_t i = 0; i < whole.size(); ++i) {
      if (whole[i].amount == 0 && shown[i].amount == 0) continue;
      const std::string hint = is_known ? time_hint(i, due[i].amount, shown[i].amount) : "";
      rows.push_back(
          Json::array({whole[i].what, amount_text(whole[i]), is_known ? amount_text(due[i]) : "",
                       amount_text(shown[i]), hint}));
    }
    if (rows.empty()) return nullptr;
    return {{"rows", rows}, {"leftOut", want->whole.left_out() + got->left_out()}};
  } catch (const std::exception&) {
    return nullptr;  // its path says why the reference ends early
  }
}

}  // namespace gonogo::oracle::report
