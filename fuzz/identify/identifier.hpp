// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of one identification. Only identify.cpp and the files beside it use it.
#pragma once

#include <map>
#include <set>

#include "fuzz/identify/identify.hpp"

namespace gonogo::identify {

class Identifier {
 public:
  Identifier(oracle::Subject& subject, const ProbePool& pool, const oracle::Grants& grants);
  Identification run();

 private:
  // A program of the pool for this run: which of its leaves can be distinguished at the subject's
  // tolerance, and whether it has been used.
  struct Item {
    const Probe* probe = nullptr;
    std::vector<std::size_t> outcome;  // of each leaf
    bool checked = false;              // `outcome` goes by the judge, not by texts alone
    bool used = false;
    std::optional<std::size_t> run;  // its place in the runs
  };

  // Readings that are lengths, in lengths.cpp.
  void find_lengths();
  struct LengthsLeft {
    std::vector<std::string> lengths;  // that explain all that was seen
    bool any_longer = false;           // all that is longer than these does, too
    bool is_one() const { return lengths.size() == 1 && !any_longer; }
  };
  LengthsLeft narrow_length(ReadingKey key, std::vector<Item*>& asked);
  std::vector<Item*> showing(ReadingKey key);
  std::vector<std::string> lengths_shown(const Item& item, ReadingKey key) const;
  bool explains(const Item& item, ReadingKey key, const std::string& length);

  // Readings distinguished by paths and alarms, in identify.cpp.
  void find_choices();
  Item* best_item();
  double information(const Item& item) const;
  void check_outcomes(Item& item);
  bool strike(Item& item);
  void judge_runs_again();
  void count_coordinates();

  // Readings that are judged by properties, in properties.cpp.
  void find_properties();
  Item* best_property_item(ReadingKey key, const std::set<const Item*>& tried);
  void narrow_properties(Item& item);
  void fix_properties();

  // Runs the program, or finds that it was run. Null: no answer.
  ProbeRun* ask(Item& item);
  bool usable(const Item& item) const;
  oracle::Verdict judge(const Item& item, const PartialAssignment& readings) const;
  // The leaves under which the program's outcome is not NO-GO.
  std::vector<PartialAssignment> explaining(const Item& item, const Outcomes& outcomes) const;
  void note_contradiction(std::size_t run, const std::vector<ReadingKey>& keys,
                          const std::vector<PartialAssignment>& left);
  // In findings.cpp.
  std::vector<ReadingFound> findings() const;
  ReadingFound choice_found(ReadingKey key) const;
  ReadingFound property_found(ReadingKey key) const;
  ReadingFound length_found(ReadingKey key) const;
  std::string why_open(ReadingKey key) const;

  // What one run leaves of its readings.
  struct Constraint {
    std::size_t run = 0;
    std::vector<ReadingKey> keys;
    std::vector<PartialAssignment> left;
  };
  Candidates all_choices() const;

  oracle::Subject& subject_;
  const ProbePool& pool_;
  const oracle::Grants& grants_;
  ReadingKinds kinds_;
  std::vector<Item> items_;
  Candidates choices_;
  Candidates properties_;
  reference::ReadingChoice base_;  // what has been found of lengths and properties
  std::set<ReadingKey> unknown_lengths_;
  std::set<ReadingKey> known_lengths_;
  std::map<ReadingKey, LengthsLeft> lengths_left_;
  std::set<ReadingKey> seen_properties_;  // a program showed the path
  std::set<std::string> skipped_features_;
  bool paths_found_ = false;
  std::optional<Profile> configured_;
  std::vector<Constraint> constraints_;
  Identification found_;
};

}  // namespace gonogo::identify
