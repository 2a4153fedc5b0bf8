// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mistakes that an implementation may make, each as a change to the reference's input or to the
// subject's output: where the judge then says GO, the subject does what the reference would do
// with that mistake.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/identify/outcome.hpp"
#include "fuzz/program/edit.hpp"

namespace gonogo::identify {

using program::ProgramText;
using program::TextBlock;
using program::TextWord;
using reference::Axis;
using reference::Code;
using reference::CodeWord;
using reference::Descriptor;
using reference::Kind;
using reference::Number;
using reference::Plane;
using reference::Position;
using reference::RecordKind;
using reference::Role;
using reference::Setting;

// What a subject that forgets to reset keeps from program to program.
struct Carried {
  std::optional<Number> feed;                     // mm
  std::map<std::string, std::string> parameters;  // "R105" -> its word
  // What a program leaves of it, up to its end.
  void take(const Profile& profile, std::string_view program, const KeptOutcome& outcome);
};

// A program that the subject has run.
struct Observation {
  std::string id;
  std::string program;
  Profile profile;
  KeptOutcome outcome;                   // of the subject
  oracle::Verdict verdict;               // under the profile
  std::uint64_t alarm = 0;               // line in which the reference alarms; 0: none
  std::vector<reference::Alarm> alarms;  // that it admits there
  Carried before;                        // left by programs that it ran before

  bool departs() const { return decision(verdict.kind) == oracle::Decision::no_go; }
};

// What is judged in place of an observation. Views of it live as long as the observation.
struct ChangedRun {
  std::string program;
  Profile profile;
  KeptOutcome outcome;
  // Compared motion by motion with `outcome`, in place of the judge, where the mistake shows in the
  // reference's records only.
  std::optional<KeptOutcome> model;
};

struct Variant {
  std::string name;  // what the subject does, a sentence without its full stop
  // Nothing: it makes no difference to this program.
  std::function<std::optional<ChangedRun>(const Observation&)> apply;
  // Where what the subject would do next is not known: whether the observation is as the mistake
  // makes it. Without `apply`, in place of a trial.
  std::function<bool(const Observation&)> holds = {};
  std::string opposite = {};  // the name of the mistake in the other sense; empty: there is none
  // A word or a code is read as another: much hangs on it, so that it explains something by chance.
  bool is_misread = false;
};

using Variants = std::vector<Variant>;

// The run of another program; nothing where there is none.
std::optional<ChangedRun> with_program(const Observation& seen, std::optional<std::string> program);

// The reference's own outcome, changed. False: it stays the same.
using ModelChange = std::function<bool(const Observation&, KeptOutcome&)>;
void add_model(std::string name, ModelChange change, Variants& out);
// The program, changed. Nothing: it stays the same.
using TextChange = std::function<std::optional<std::string>(const ProgramText&)>;
void add_text(std::string name, TextChange change, Variants& out);
void add_edit(std::string name, program::WordEdit edit, Variants& out);
// The words that go are ignored.
void add_without(std::string name, program::WordTest goes, Variants& out);
// The subject's outcome, with what the mistake made of it undone.
using OutcomeChange = std::function<void(const Observation&, KeptOutcome&)>;
void add_outcome(std::string name, OutcomeChange change, Variants& out);

// Codes that a mistake may be of: the one in force where the observation departs, alone and with
// those that the same cycle is written for. Empty: it is not known.
using Motions = std::set<std::string, std::less<>>;
std::vector<Motions> motions_concerned(const Observation& departure);
// Whether the two are programmed with the same words.
bool has_same_words(const Code& a, const Code& b);
// Addresses of the dialect with words of these roles; of places those of rotary axes or the others.
std::set<std::string> addresses_with(const Descriptor& table, std::initializer_list<Role> roles,
                                     bool rotary = false);
// Addresses whose words one mistake is likely to meet together.
std::vector<std::set<std::string>> kin_addresses(const Descriptor& table);
// The word of a cycle's taper, where it has but one length with a sign. Null: it has none or more.
const CodeWord* taper_of(const Code& code);
// Addresses that stand in the program, but codes.
std::set<std::string> addresses_in(const ProgramText& program);
// With so many decimals.
Number half_up(const Number& value, int places);
// R105 and similar ones.
bool is_parameter(const std::string& name);
// "G110 G111", or "all cycles" of a dialect.
std::string names_of(const Motions& motions);
// Whether the line of this number runs one of the codes.
bool is_of(const ProgramText& program, std::uint64_t line, const Motions& motions);

// Where the machine stands when each block begins, by line; and what the block puts out.
struct BlockPath {
  Position start;
  std::vector<Record> records;
};
// Empty: the reference cannot decide the program.
std::vector<BlockPath> paths_of(const Observation& seen, std::size_t blocks);

// Each family adds what can matter to the observations, the departing ones first.
// A reading switched; units, diameter, offsets, parameters and the like of the machine.
void add_machine_variants(const Observation& departure, Variants& out);
// A word negated, doubled, halved, in other units, ignored, exchanged with another.
void add_word_variants(const Observation& departure, Variants& out);
// A word with AC or IC, or with neither, read as another of them.
void add_bracket_variants(const Observation& departure, Variants& out);
// A code taken for another one, ignored; words that stay in force too long or not long enough.
void add_code_variants(const Observation& departure, Variants& out);
void add_modal_variants(const Observation& departure, Variants& out);
void add_retained_variants(const Observation& departure, Variants& out);
// What came out turned round, mirrored, in other units, under other block numbers, at another
// speed.
void add_record_variants(const Observation& departure, Variants& out);
// A rule that is not checked.
void add_alarm_variants(const Observation& departure, Variants& out);
// A limit that its own value counts as beyond, or not.
void add_limit_variants(const Observation& departure, Variants& out);
// A motion that a clause asks for of another kind, or left out.
void add_clause_variants(const Observation& departure, Variants& out);
// The way to a reference point.
void add_reference_point_variants(const Observation& departure, Variants& out);
// Where a motion ends, and along which way a lead counts.
void add_way_variants(const Observation& departure, Variants& out);
// Coordinates rounded; motions left out; steps counted otherwise.
void add_model_variants(const Observation& departure, Variants& out);
void add_step_variants(const Observation& departure, Variants& out);

}  // namespace gonogo::identify
