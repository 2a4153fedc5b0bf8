// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs whose outcome distinguishes readings.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "corpus/io/corpus.hpp"
#include "fuzz/identify/candidates.hpp"
#include "fuzz/identify/outcome.hpp"

namespace gonogo::identify {

// The value after a reading's alternatives: none of the named ones. Only of readings that are
// judged by properties.
ReadingValue value_of_none(const Reading& reading);
// "r-plane"; "any" for none of the named ones.
std::string_view text_of(const Reading& reading, ReadingValue value);
void set_values(Profile& profile, const PartialAssignment& assignment);

// The outcomes of a program as a tree of the readings that it asks for: each leaf says what it
// needs, and which leaves look the same.
struct Outcomes {
  struct Leaf {
    PartialAssignment readings;
    std::size_t outcome = 0;  // equal numbers: equal outcomes
  };
  std::vector<ReadingKey> keys;  // of all leaves, sorted
  std::vector<Leaf> leaves;
  std::size_t different = 1;

  // Whether two leaves that differ in this reading alone have different outcomes.
  bool tells_apart(ReadingKey key) const;
  std::string signature() const;
};

struct Probe {
  std::string id;
  std::string program;
  Profile profile;  // the machine; its readings are the defaults
  std::set<std::string> features;
  Outcomes by_reading;           // of the readings that are not judged by properties
  Outcomes by_property;          // of the others, under the defaults of the first
  std::set<ReadingKey> lengths;  // readings that are lengths and matter here
  std::size_t by_length = 1;     // different outcomes under some lengths of them
  // `by_reading` is what comes out under named paths: of use once they have been found.
  bool named_paths = false;
};

// The readings of a dialect, by kind.
struct ReadingKinds {
  std::vector<ReadingKey> choices;     // distinguished by paths, alarms
  std::vector<ReadingKey> properties;  // judged by properties unless a path is named
  std::vector<ReadingKey> lengths;
};
ReadingKinds reading_kinds(std::string_view dialect);

// Nothing: no reading matters, the program is not covered, or it costs too much.
std::optional<Probe> make_probe(std::string id, std::string program, Profile profile);

// The same program for readings that make a difference under named paths only. Nothing: there are
// none.
std::optional<Probe> with_named_paths(const Probe& probe);

// The programs that distinguish readings of a dialect, few for each way of doing it.
struct ProbePool {
  std::string dialect;
  std::vector<Probe> probes;
  std::size_t seen = 0;  // programs looked at
  std::size_t generated = 0;

  // Whether a program distinguishes two values of the reading.
  bool shows(ReadingKey key) const;
};

// The cases of the corpus and, for readings that none of them shows, generated programs. `machine`:
// that of every program; nothing: each program's own. REQUIRES: `dialect` is one that the gauge
// reads. Throws CorpusError.
ProbePool make_pool(const oracle::Corpus& corpus, std::string_view dialect,
                    const std::optional<Profile>& machine);

}  // namespace gonogo::identify
