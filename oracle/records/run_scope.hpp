// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run covers: which features were judged, what of the corpus the subject does not claim,
// what it claims and skips, and the advices. Takes case lines one at a time; its memory depends on
// features and clauses, not on cases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "oracle/records/case_head.hpp"
#include "oracle/records/subject_outcome.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

// g90 before g110, as people count.
struct NaturalOrder {
  bool operator()(std::string_view a, std::string_view b) const;
};

class RunScope {
 public:
  // Cases of one kind, with the ids of the first.
  struct Group {
    std::size_t cases = 0;
    std::vector<std::string> first;
  };
  // What was skipped: a feature that the subject does not declare, or for a reason of its own.
  struct Skipped {
    std::string dialect;
    std::string feature;  // empty: for another reason
    std::string message;  // that one
    auto operator<=>(const Skipped&) const = default;
  };
  // A feature that is declared, and yet cases of it are skipped.
  struct Broken {
    std::string dialect;
    std::string cycle;
    std::string message;
    auto operator<=>(const Broken&) const = default;
  };
  // Advices about one thing: the clause departed from, and the verdict that it would be.
  struct Advice {
    std::string clause;
    std::string departure;
    auto operator<=>(const Advice&) const = default;
  };
  // For the cases that need a feature.
  struct Judged {
    std::size_t cases = 0;
    std::size_t no_go = 0;      // of them
    std::size_t to_blame = 0;   // of those; `basic` only where the case needs nothing else
    std::size_t skipped = 0;    // for another reason than a feature that is not declared
    std::size_t unsettled = 0;  // an advice, a known failure, a gap that the corpus does not expect

    std::size_t all() const { return cases + skipped + unsettled; }
    // Whether the greater part was judged.
    bool is_judged() const { return cases > 0 && cases >= skipped + unsettled; }
    bool is_go() const { return is_judged() && no_go == 0; }
  };

  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  // What became of cases; each is counted once.
  struct Counts {
    std::size_t go = 0;
    std::size_t no_go = 0;
    std::size_t advised = 0;
    std::size_t known = 0;
    std::size_t undecided = 0;
    std::size_t skipped = 0;
    std::size_t not_covered = 0;  // the corpus expects no answer

    std::size_t judged() const { return go + no_go; }
  };
  using Cycles = std::map<std::string, Counts, NaturalOrder>;

  RunScope() = default;
  // `subject`: what it declares of dialects and features. Nothing: it is not known, and a skip is
  // taken at its word where it names a feature of its case.
  explicit RunScope(std::optional<SubjectInfo> subject) : subject_(std::move(subject)) {}

  // `kind`: in the run, which may be another than the line's own.
  void add(const CaseHead& line, VerdictKind kind);

  // "GO for basic, g94 of gsk988ta: 156 judged, 3 advices; not claimed: g90, g92 (5,085 cases)";
  // "NO-GO: g94 of gsk988ta fails 252 of 878 cases; GO: basic of gsk988ta; 593 of 865 judged are
  // GO". `most`: names of features of a dialect; the others are counted. `stale`: entries of the
  // subject's files that are no longer true, which make a NO-GO by themselves.
  using Entries = std::vector<std::string>;
  std::string head(std::string_view decision, std::size_t most = kAll,
                   const Entries& stale = {}) const;
  // The same in less room: "GO · basic, g94 of gsk988ta · 156 judged, 5,085 not claimed"; of a
  // NO-GO the first features that fail and the first that are GO.
  std::string short_head(std::string_view decision, const Entries& stale = {}) const;

  // Whether a feature of each dialect is GO.
  bool claims_every_dialect() const;
  std::size_t judged() const { return all_.judged(); }
  std::size_t no_go() const { return all_.no_go; }
  // Not claimed; without those that the corpus expects no answer to.
  std::size_t skipped() const { return all_.skipped; }
  std::size_t advised() const { return all_.advised; }
  std::size_t known() const { return all_.known; }
  std::size_t undecided() const { return all_.undecided; }
  std::size_t not_covered() const { return all_.not_covered; }
  // Dialect -> cycle.
  const std::map<std::string, Cycles>& cycles() const { return cycles_; }
  // Dialect -> feature; features of every subject (`m`, `bytes`) are no part of it.
  using Features = std::map<std::string, Judged, NaturalOrder>;
  const std::map<std::string, Features>& features() const { return features_; }
  const std::map<Skipped, Group>& not_claimed() const { return not_claimed_; }
  const std::map<Broken, Group>& broken() const { return broken_; }
  const std::map<Advice, Group>& advices() const { return advices_; }

 private:
  bool is_undeclared(const CaseHead& line) const;
  void count_features(const CaseHead& line, VerdictKind kind);
  enum class Fold : std::uint8_t { first, number };  // of too many names
  std::string go_features(std::size_t most, Fold fold) const;
  std::string failing_features(std::size_t most) const;
  std::string score() const;
  std::string hardly_judged() const;
  std::string counts() const;
  std::string skips(std::size_t most) const;

  std::optional<SubjectInfo> subject_;
  Counts all_;
  std::set<std::string> dialects_;
  std::map<std::string, Features> features_;
  std::map<std::string, Cycles> cycles_;
  std::map<std::string, Judged> nameless_;  // by dialect: cases that need no feature of their own
  std::map<Skipped, Group> not_claimed_;
  std::map<Broken, Group> broken_;
  std::map<Advice, Group> advices_;
};

// What an entry of the alarm map begins with where a footer says that it is stale.
inline constexpr std::string_view kStaleAlarm = "alarm map ";
// "6,613"
std::string grouped(std::size_t count);
// "12 cases", "1 case"
std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace gonogo::oracle
