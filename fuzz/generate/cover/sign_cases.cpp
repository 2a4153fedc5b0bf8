// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/sign_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "fuzz/generate/cover/boundary.hpp"
#include "fuzz/generate/cover/drawing.hpp"
#include "corpus/io/sha256.hpp"

namespace gonogo::cover {
namespace {

using oracle::Case;

constexpr std::size_t kProgramsTried = 24;

// Where readings are open, under the alternatives shown first: what others make of a case does not
// choose the cases.
bool is_valid(const Case& test) {
  return test.expect.front().alarms.empty() && !test.expect.front().not_covered;
}

std::string id_of(const Making& making, const Case& from, const Triple& triple, std::size_t side) {
  oracle::Sha256 hash;
  hash.update(reference::profile_json(from.profile));
  hash.update(triple.address);
  hash.update(own_text(triple.programs[1], from.dialect));
  return fmt::format("{}.sign-{}.{:06}", making.model->name, hash.hex().substr(0, 10), side + 1);
}

// A case at a limit has one fault.
bool has_several_faults(const Case& test) {
  std::set<reference::AlarmClass> classes;
  for (const oracle::ExpectedAlarm& alarm : test.expect.front().alarms) classes.insert(alarm.alarm);
  return classes.size() > 1;
}

bool rests_on_silence(const Case& test) {
  return test.expect.front().basis == reference::Basis::silent;
}

// The three cases of a limit, or none of them: not where a rule decides that no text states.
void add_cases(const Making& making, const Case& from, const Triple& triple,
               std::vector<Case>& cases) {
  const std::size_t before = cases.size();
  struct Side {
    const char* mark;
    const char* text;
  };
  constexpr std::array<Side, 3> kSides = {
      {{"-", "one increment below"}, {"0", "on"}, {"+", "one increment above"}}};
  for (std::size_t side = 0; side < kSides.size(); ++side) {
    Case test = from;
    test.id = id_of(making, from, triple, side);
    test.program = triple.programs[side];
    test.comment = fmt::format("{} {} what {} decides by, in {}", triple.address, kSides[side].text,
                               triple.clause, from.comment);
    test.tags_tway.clear();
    test.tags_sign = {fmt::format("{}:{}", triple.clause, kSides[side].mark)};
    test.group = group_name(fmt::format("{}.sign", making.model->name), test);
    test.expect = expectations_of(test.profile, test.program);
    if (has_several_faults(test) || rests_on_silence(test) || making.left_out.contains(test.id)) {
      cases.resize(before);
      return;
    }
    cases.push_back(std::move(test));
  }
}

}  // namespace

std::vector<Case> sign_cases(const Making& making, const std::vector<DrawnCase>& from) {
  std::vector<Case> cases;
  std::vector<const DrawnCase*> valid;
  for (const DrawnCase& drawn : from) {
    if (is_valid(drawn.test)) valid.push_back(&drawn);
  }
  // One in so many, from all over the array.
  const std::size_t stride = std::max<std::size_t>(valid.size() / kProgramsTried, 1);
  std::set<std::string> kinds;
  std::set<std::string> ids;  // where both neighbours of a value differ from it, the triple is one
  for (std::size_t i = 0; i < valid.size() && kinds.size() < making.signs; i += stride) {
    const Case& test = valid[i]->test;
    for (const VariedWord& word : varied_words(test.program, 2, valid[i]->test_line)) {
      for (const Triple& triple :
           boundary_triples(test.profile, test.program, word, valid[i]->decimals)) {
        if (kinds.size() == making.signs) break;
        if (!ids.insert(id_of(making, test, triple, 0)).second) continue;
        if (!kinds.insert(word.address + " " + triple.change).second) continue;
        add_cases(making, test, triple, cases);
      }
    }
  }
  std::ranges::sort(cases, {}, &Case::id);
  return cases;
}

}  // namespace gonogo::cover
