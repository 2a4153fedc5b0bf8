// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/sign_coverage.hpp"

#include "fuzz/hunt/hunt.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::hunt {
namespace {

constexpr std::size_t kMostItems = 100'000;  // of a case

void expand(const reference::Profile& profile, const std::string& program) {
  oracle::ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  for (std::size_t items = 0; items < kMostItems && expander.next() != nullptr;) ++items;
}

// Under every alternative of what the case leaves open.
void expand_case(const oracle::Case& test) {
  try {
    for (const reference::ReadingChoice& choice :
         oracle::assignments_of(test.profile, test.program).choices) {
      reference::Profile profile = test.profile;
      profile.readings = choice;
      expand(profile, test.program);
    }
  } catch (const exact::Undecided&) {
    // As far as it is known.
  }
}

}  // namespace

void SignCounter::note(const reference::Decision& decision) {
  if (decision.clause == reference::kNoClause) return;
  const std::size_t place = decision.sign < 0 ? 0 : decision.sign == 0 ? 1 : 2;
  ++counts_[{decision.clause, std::string(decision.what)}][place];
}

SignCounter::Counts signs_of_corpus(const oracle::Corpus& corpus, std::string_view dialect) {
  SignCounter counter;
  oracle::CaseReader reader(corpus, oracle::Detail::to_run, {std::string(dialect)});
  while (const auto test = reader.next()) expand_case(*test);
  return counter.counts();
}

SignCounter::Counts signs_of_hunt(const SubjectMaker& subject, const std::string& dialect,
                                  std::uint64_t seed, std::size_t programs) {
  HuntOptions options;
  options.dialect = dialect;
  options.seed = seed;
  options.everywhere = true;  // the domain says what is a finding, and nothing here is one
  Hunt hunt(subject, {}, options);
  SignCounter counter;
  for (std::size_t i = 0; i < programs; ++i) hunt.step();
  return counter.counts();
}

std::vector<SignRow> sign_rows(const SignCounter::Counts& corpus, const SignCounter::Counts& hunt) {
  std::map<std::pair<std::string, std::string>, SignRow> rows;
  const auto row_of = [&](const SignCounter::Counts::key_type& key) -> SignRow& {
    const std::string clause(reference::clause_name(key.first));
    SignRow& row = rows[{clause, key.second}];
    row.clause = clause;
    row.what = key.second;
    return row;
  };
  for (const auto& [key, signs] : corpus) row_of(key).corpus = signs;
  for (const auto& [key, signs] : hunt) row_of(key).hunt = signs;
  std::vector<SignRow> sorted;
  for (auto& [key, row] : rows) sorted.push_back(std::move(row));
  return sorted;
}

SignSummary summary_of(const std::vector<SignRow>& rows) {
  SignSummary summary;
  summary.comparisons = rows.size();
  for (const SignRow& row : rows) {
    for (std::size_t i = 0; i < row.corpus.size(); ++i) {
      const bool in_corpus = row.corpus[i] != 0;
      const bool in_hunt = row.hunt[i] != 0;
      if (in_corpus) ++summary.corpus;
      if (in_hunt) ++summary.hunt;
      if (in_corpus || in_hunt) ++summary.either;
    }
  }
  return summary;
}

std::string met(const Signs& signs) {
  std::string text = "- 0 +";
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (signs[i] == 0) text[2 * i] = ' ';
  }
  return text;
}

}  // namespace gonogo::hunt
