// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>

#include "oracle/records/finding_text.hpp"
#include "oracle/records/run_scope.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::size_t kFirstOfFinding = 20;
// A subject may break down in another way each time; what is beyond so many is counted as one.
constexpr std::size_t kMostFindings = 200;

// No record of the subject tells what it is about.
bool is_told_by_message(VerdictKind kind) {
  return is_breakdown(kind) || kind == VerdictKind::fail_declaration;
}

// The value of a key in the text of a record or an alarm.
std::string member(std::string_view text, std::string_view key) {
  const std::string begin = fmt::format("\"{}\":\"", key);
  const std::size_t at = text.find(begin);
  if (at == std::string_view::npos) return {};
  const std::size_t from = at + begin.size();
  return std::string(text.substr(from, text.find('"', from) - from));
}

// What the text of a verdict is about: the class of an alarm, the kind of a record, "end".
std::string about(std::string_view text) {
  const std::string alarm = member(text, "class");
  if (!alarm.empty()) return alarm;
  const std::string kind = member(text, "k");
  return !kind.empty() ? kind : text == "end" ? std::string(text) : std::string();
}

constexpr std::size_t kLongestHeading = 80;  // bytes of a heading

// The sentence with "..." for what changes from run to run: numbers, quoted parts.
std::string constant_part(std::string_view said) {
  constexpr std::string_view kQuotes = "\"`";
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string text;
  for (std::size_t at = 0; at < said.size(); ++at) {
    if (is_digit(said[at])) {
      text += "...";
      while (at + 1 < said.size() && is_digit(said[at + 1])) ++at;
      continue;
    }
    text += said[at];
    if (kQuotes.find(said[at]) == std::string_view::npos) continue;
    text += "...";
    at = said.find(said[at], at + 1);
    if (at == std::string_view::npos) break;
    text += said[at];
  }
  return excerpt(text, kLongestHeading);
}

bool is_finding(const CaseHead& line, VerdictKind kind) {
  if (kind == VerdictKind::oracle_gap) return !line.expected;
  return kind == VerdictKind::oracle_error || decision(kind) == Decision::no_go;
}

// A program that is not kept is no example while there is another.
auto size_of(const Finding::Example& example) {
  return std::tuple(example.blocks == 0, example.blocks, example.bytes,
                    std::string_view(example.id));
}

// A motion of another kind, which is not the traverse that collides: less grave than a wrong place.
bool is_label(const Finding::Key& key) {
  const std::size_t slash = key.what.find('/');
  if (slash == std::string::npos) return false;
  const std::string_view want = std::string_view(key.what).substr(0, slash);
  const std::string_view got = std::string_view(key.what).substr(slash + 1);
  return !want.empty() && !got.empty() && want != got && got != "rapid";
}

Finding::Key shown_key(const CaseHead& line, VerdictKind kind) {
  return {gravity(kind), kind, line.dialect, line.clause,
          departed_about(kind, line.want, line.got, line.message)};
}

// What its finding has in common.
Finding::Key key_of(const CaseHead& line, Finding::Key shown) {
  const bool is_undue =
      shown.kind == VerdictKind::fail_alarm_spurious || shown.kind == VerdictKind::fail_alarm_class;
  if (!is_undue && !is_of_earlier_block(line.want, line.got)) return shown;
  shown.clause.clear();
  shown.what = (is_undue ? "not due: " : "of an earlier block: ") + about(line.got);
  if (!is_undue) return shown;
  shown.kind = VerdictKind::fail_alarm_spurious;
  shown.gravity = gravity(shown.kind);
  return shown;
}

}  // namespace

bool is_of_earlier_block(std::string_view want, std::string_view got) {
  const std::optional<std::uint64_t> due = line_wanted(want);
  const std::optional<std::uint64_t> came = line_wanted(got);
  return due && came && *came < *due && !member(got, "k").empty() && member(got, "class").empty();
}

bool is_other_answer(VerdictKind kind) {
  return kind >= VerdictKind::fail_geometry && kind <= VerdictKind::fail_alarm_late;
}

bool is_breakdown(VerdictKind kind) {
  return kind == VerdictKind::oracle_error ||
         (kind >= VerdictKind::crash && kind <= VerdictKind::protocol);
}

std::string departed_about(VerdictKind kind, std::string_view want, std::string_view got,
                           std::string_view message) {
  if (is_told_by_message(kind)) return constant_part(message);
  return fmt::format("{}/{}", about(want), about(got));
}

unsigned gravity(VerdictKind kind) {
  constexpr VerdictKind kOrder[] = {
      VerdictKind::fail_geometry,  VerdictKind::fail_region,         VerdictKind::fail_order,
      VerdictKind::fail_overrun,   VerdictKind::fail_alarm_missing,  VerdictKind::fail_alarm_late,
      VerdictKind::fail_feed,      VerdictKind::state_leak,          VerdictKind::crash,
      VerdictKind::timeout,        VerdictKind::out_of_memory,       VerdictKind::protocol,
      VerdictKind::fail_reading,   VerdictKind::fail_alarm_spurious, VerdictKind::fail_alarm_class,
      VerdictKind::unmapped_alarm, VerdictKind::fail_declaration,    VerdictKind::xpass,
      VerdictKind::oracle_error,   VerdictKind::oracle_gap};
  return static_cast<unsigned>(std::ranges::find(kOrder, kind) - std::begin(kOrder));
}

std::string Cause::text() const {
  if (empty()) return {};
  return fmt::format("Behaves as if: {}.{}{}", name, evidence.empty() ? "" : " ", evidence);
}

std::string Finding::place() const {
  std::string out = shown.clause.empty() ? std::string() : " at " + shown.clause;
  const bool is_told = is_told_by_message(shown.kind);
  const bool is_one = is_told && messages.size() == 1 && !messages.begin()->empty();
  const std::string said = is_one ? excerpt(*messages.begin(), kLongestHeading) : shown.what;
  const std::string_view what = said;
  const std::size_t slash = what.find('/');
  if (is_told || slash == std::string_view::npos) {
    return what.empty() ? out : fmt::format("{} ({})", out, what);
  }
  const std::string_view want = what.substr(0, slash);
  const std::string_view got = what.substr(slash + 1);
  if (want.empty() && got.empty()) return out;
  if (want == got || got.empty()) return fmt::format("{} ({})", out, want);
  return want.empty() ? fmt::format("{} ({} too many)", out, got)
                      : fmt::format("{} ({} for {})", out, got, want);
}

std::string Finding::text() const {
  if (kinds.empty()) return std::string(name(shown.kind)) + place();
  std::string names;
  for (const auto& [kind, its] : kinds) {
    names += fmt::format("{}{}", names.empty() ? "" : " and ", name(kind));
  }
  return names + place();
}

std::string Finding::cycle() const {
  const auto most =
      std::ranges::max_element(by_cycle, {}, [](const auto& one) { return one.second; });
  return most == by_cycle.end() ? std::string() : most->first;
}

std::string Finding::line() const {
  std::string counts;
  for (const auto& [kind, its] : kinds) {
    counts += fmt::format("{}{} x {}", counts.empty() ? "" : ", ", grouped(its), name(kind));
  }
  std::string out = fmt::format("{}{}, smallest: {}", counts, place(), smallest.id);
  if (smallest.blocks == 0) return out;
  return out + fmt::format(", {} {}", grouped(smallest.blocks),
                           smallest.blocks == 1 ? "block" : "blocks");
}

const Finding* Findings::add(const CaseHead& line, VerdictKind kind) {
  is_smallest_ = false;
  if (!is_finding(line, kind)) return nullptr;
  Finding::Key shown = shown_key(line, kind);
  Finding::Key key = key_of(line, shown);
  if (findings_.size() >= kMostFindings && !findings_.contains(key)) {
    key.dialect = key.clause = "";
    key.what = "of further kinds";
    shown = key;
  }
  auto [place, added] = findings_.try_emplace(std::move(key));
  Finding& finding = place->second;
  if (added) {
    finding.key = place->first;
    finding.shown = shown;
    finding.number = findings_.size();
    const auto cause = causes_.find(place->first);
    if (cause != causes_.end()) finding.cause = cause->second;
  }
  ++finding.kinds[kind];
  finding.shown.kind = finding.kinds.begin()->first;
  if (finding.shown.clause != shown.clause) finding.shown.clause.clear();
  if (finding.shown.what != shown.what) finding.shown.what = finding.key.what;
  ++finding.cases;
  ++finding.by_cycle[line.cycle];
  if (finding.first.size() < kFirstOfFinding) finding.first.push_back(line.id);
  const Finding::Example example{line.id, line.message, line.program_blocks, line.program_bytes};
  if (finding.messages.size() < 2) finding.messages.insert(line.message);
  is_smallest_ = added || size_of(example) < size_of(finding.smallest);
  if (is_smallest_) finding.smallest = example;
  return &finding;
}

void Findings::set_cause(const Finding::Key& key, Cause cause) {
  if (const auto found = findings_.find(key); found != findings_.end()) found->second.cause = cause;
  causes_[key] = std::move(cause);
}

std::vector<const Finding*> Findings::list(Order order) const {
  std::vector<const Finding*> all;
  for (const auto& [key, finding] : findings_) all.push_back(&finding);
  std::ranges::sort(all, [order](const Finding* a, const Finding* b) {
    if (order == Order::cycle && a->cycle() != b->cycle()) {
      return NaturalOrder()(a->cycle(), b->cycle());
    }
    return std::tuple(a->key.gravity, is_label(a->key), size_of(a->smallest)) <
           std::tuple(b->key.gravity, is_label(b->key), size_of(b->smallest));
  });
  std::vector<const Finding*> together;
  for (const Finding* finding : all) {
    if (std::ranges::find(together, finding) != together.end()) continue;
    together.push_back(finding);
    if (finding->cause.empty()) continue;
    std::ranges::copy_if(all, std::back_inserter(together), [&](const Finding* other) {
      return other != finding && other->cause.name == finding->cause.name;
    });
  }
  return together;
}

}  // namespace gonogo::oracle
