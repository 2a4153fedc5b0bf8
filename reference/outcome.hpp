// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reference says about a program, item by item: records, levels to be cleared, and how
// it ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/record.hpp"
#include "reference/word_name.hpp"

namespace gonogo::reference {

enum class AlarmClass : std::uint8_t {
#define GONOGO_ALARM(name, text, sentence) name,
#include "reference/alarm_classes.def"
};
inline constexpr std::size_t kAlarmClasses =
    std::initializer_list<AlarmClass>{
#define GONOGO_ALARM(name, text, sentence) AlarmClass::name,
#include "reference/alarm_classes.def"
    }
        .size();
std::string_view name(AlarmClass alarm);
std::optional<AlarmClass> alarm_class(std::string_view text);

class AlarmClasses {
 public:
  void add(AlarmClass alarm) { bits_ |= bit(alarm); }
  bool has(AlarmClass alarm) const { return (bits_ & bit(alarm)) != 0; }

 private:
  static std::uint64_t bit(AlarmClass alarm) {
    return std::uint64_t{1} << static_cast<unsigned>(alarm);
  }
  std::uint64_t bits_ = 0;
};

// One rule that a block breaks.
struct Alarm {
  AlarmClass alarm = AlarmClass::syntax;
  ClauseId clause = kNoClause;
  WordName word;           // the address at fault or missing; empty: none
  grammar::Span where;     // of the word; past the line's end when it is missing
  std::string message;     // a sentence with the values
  AlarmClasses also = {};  // other classes that a reader of the rule may choose
};

// A block with at least one broken rule; the program ends before its motion. Any of them may be
// reported; the first is the one whose word stands first.
struct AlarmReport {
  std::uint64_t block = 0;
  std::vector<Alarm> alarms;
  std::optional<grammar::SyntaxError> syntax;
};

// A class that a report admits, and the rule that it is of.
struct AdmittedClass {
  AlarmClass alarm = AlarmClass::syntax;
  const Alarm* of = nullptr;
};
// Each once: those of the broken rules in their order, then the other classes of each.
std::vector<AdmittedClass> admitted_classes(const AlarmReport& report);
// `classes`: one, or several between blanks, where the text of an alarm stands for several.
bool admits(const AlarmReport& report, std::string_view classes);

// The first alarm of a block that rests on a text; else the first that is derived;
// else the first: the clause that a departure from them departs from (docs/judging.md, J-ALM-01).
// REQUIRES: there is one.
const Alarm& best_supported(const AlarmReport& report);

// A code, word or construct that the maker has and the gauge does not read, or something of the
// machine that the profile does not say; the program ends here for the gauge.
struct NotCovered {
  std::uint64_t block = 0;
  std::string code;  // the code or the word; "profile" for what the profile lacks
  std::string message;
  grammar::Span where;
  // The line of TOML that the profile lacks, with a value that stands for the machine's own; empty:
  // nothing of the profile.
  std::string lacks = {};
};
inline constexpr std::string_view kLackingProfile = "profile";

// Something of a block that the gauge ignores, and that a reader should know of.
struct Warning {
  std::string message;  // a sentence
  grammar::Span where;
};

// One level of a circular pocket whose path the manual leaves open (reading gsk.pocket.path = any):
// the motions between the plunge and the retract, judged by what they clear.
struct PocketLevel {
  std::uint64_t block = 0;
  ClauseId clause = kNoClause;
  Plane plane = Plane::g18;
  std::array<Number, 2> centre;  // along p and q
  Number depth;                  // coordinate of d
  Number pocket_radius;          // I
  Number tool_radius;            // D
  Number step;                   // L
  int sense = -1;                // sign of rot
  Number feed;
  FeedMode feed_mode = FeedMode::per_minute;
  friend bool operator==(const PocketLevel&, const PocketLevel&) = default;
};

// How the tool leaves a thread at its bottom: as one of the given readings says; open: any one of
// them, the same in a whole program.
enum class ThreadRunOut : std::uint8_t { open, polar, radial, tangent };

// The passes of one thread milling block where the manual leaves their path open (readings
// gsk.thread.path and gsk.thread.runout): everything between the arrival above the centre at the R
// plane and the traverse to the initial plane. mm as true lengths.
struct ThreadMilling {
  std::uint64_t block = 0;
  ClauseId clause = kNoClause;
  Plane plane = Plane::g18;
  bool external = true;
  int sense = -1;                // sign of rot of the helices
  std::array<Number, 2> centre;  // along p and q
  Number r_plane;                // coordinate of d where the helices begin
  Number bottom;                 // coordinate of d where they end
  Number travel;                 // bottom - r_plane, exact also where both are only enclosed
  Number initial_plane;          // coordinate of d to which the cycle returns after them
  Number lead;                   // I
  Number start_radius;           // E/2 + D external, E/2 - D internal
  Number tool_radius;            // D
  Number height;                 // P
  Number infeed;                 // Q of a pass; P where all is one pass
  Number runout_length;          // J
  Number runout_angle;           // K, degrees
  bool arc_path = false;         // the reading gsk.thread.path = arc
  ThreadRunOut runout = ThreadRunOut::open;
  Number feed;
  FeedMode feed_mode = FeedMode::per_minute;

  Number passes() const { return (height / infeed).ceil(); }
  // t_n, how far pass n (from 1) has come in: min(n Q, P).
  Number depth_of_pass(const Number& n) const { return min(n * infeed, height); }
  Number radius_of_pass(const Number& n) const {
    return external ? start_radius - depth_of_pass(n) : start_radius + depth_of_pass(n);
  }
  friend bool operator==(const ThreadMilling&, const ThreadMilling&) = default;
};

// The milling of one helical pocket where the side of its entry is open (reading
// gsk.helix.entry-side = any): a semicircle from the centre to the circle of radius I - D, the
// helix of L turns, perhaps a flat turn, and the semicircle back to the centre. mm as true lengths.
struct HelixPocket {
  std::uint64_t block = 0;
  ClauseId clause = kNoClause;
  Plane plane = Plane::g18;
  std::array<Number, 2> centre;  // along p and q: where the path begins and ends
  Number r_plane;                // coordinate of d where the helix begins
  Number bottom;                 // coordinate of d where it ends
  Number radius;                 // I - D
  std::int32_t turns = 1;        // L
  int sense = -1;                // sign of rot of all arcs
  bool flat = false;             // the reading gsk.helix.flat = on: a full circle at the bottom
  Number feed;
  FeedMode feed_mode = FeedMode::per_minute;
  friend bool operator==(const HelixPocket&, const HelixPocket&) = default;
};

// How the depth of a pocket is divided into levels.
enum class Levels : std::uint8_t {
  equal,     // equal infeeds, as few as R121 allows
  max_rest,  // whole infeeds, and what is left
  open,      // strictly falling, the first not below the reference plane less R121, no step above
             // R121, the last on the floor
};

// The milling of one pocket of LCYC75, whose path the manual leaves open (reading
// sie.pocket.path): everything between the arrival at the clearance above the centre and the
// arrival at R101 above the centre. mm as true lengths, in base coordinates; lengths of the pocket
// are its own.
struct PocketMilling {
  std::uint64_t block = 0;
  ClauseId clause = kNoClause;
  Plane plane = Plane::g17;
  std::array<Number, 2> centre;     // along p and q
  std::array<Number, 2> direction;  // of its length: cosine and sine from p toward q
  Number clearance;                 // coordinate of d where the milling begins: R103 + R102
  Number reference_plane;           // coordinate of d: R103
  Number retract;                   // coordinate of d where it ends: R101
  Number floor;                     // coordinate of d of the last level
  Number rough_floor;               // finishing: coordinate of d that roughing left
  Number length, width;  // of what the tool may touch: R118 and R119, less twice R124 in roughing
  Number corner_radius;  // of that, not below the tool's radius
  Number allowance;      // finishing: R124, the strip that roughing left; else 0
  Number tool_radius;
  Number infeed;  // R121
  Levels levels = Levels::open;
  bool levels_from_clearance = false;  // equal and max_rest: from R103 + R102, not from R103
  bool finishing = false;
  bool contour_only = false;  // finishing: the floor is not milled
  bool one_level = false;     // finishing: one level at the floor is admissible for any R121
  int sense = -1;             // sign of rot of the pass along the border
  Number depth_feed;          // R122
  Number plane_feed;          // R123
  FeedMode feed_mode = FeedMode::per_minute;

  // SIE-LC75-05, SIE-LC75-06, in lcyc75_levels.cpp. Where the first infeed begins, how many levels
  // there are, and the coordinate of d of level k, from 1; `open` is shown as equal infeeds.
  Number top() const;
  Number level_count() const;
  Number depth_of_level(const Number& k) const;
  friend bool operator==(const PocketMilling&, const PocketMilling&) = default;
};

// The position got a new name (G50): nothing moves and no record says so, but the records that
// follow are in the new coordinates.
struct Renaming {
  std::uint64_t block = 0;
  Position shift;  // new coordinate less old one
  friend bool operator==(const Renaming&, const Renaming&) = default;
};

using Item = std::variant<Record, PocketLevel, HelixPocket, ThreadMilling, PocketMilling, Renaming,
                          AlarmReport, NotCovered>;

// Whether two items demand the same of a subject, though under other clauses: records of one
// content, alarms of the same classes on the same grounds.
bool says_the_same(const Item& a, const Item& b);

}  // namespace gonogo::reference
