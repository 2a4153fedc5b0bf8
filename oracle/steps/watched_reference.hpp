// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run of the reference, and beside it one for each other alternative of an open reading that it
// asks for: as long as they put out the same, the one run stands for all of them (J-READ-01).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "oracle/steps/assignment_set.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

// When another alternative is reported: where it differs, or where the reading is asked for.
enum class Forking : std::uint8_t { when_different, when_asked };

class WatchedReference {
 public:
  // `watched`: the assignments from which the profile's readings were taken; null: only these
  // readings count. Everything must outlive the run.
  WatchedReference(const reference::Profile& profile, const ProgramText& program,
                   const AssignmentSet* watched, Forking forking);
  ~WatchedReference();

  // The same as in an Expander.
  const reference::Item* next();
  void stand_at(const reference::Position& position);
  void go_past_end();
  const reference::ReadingsInUse& readings() const { return expander_.readings(); }
  bool is_in_order() const { return expander_.is_in_order(); }
  std::string failed_words() const { return expander_.failed_words(); }

  // An alternative under which the last item, or an earlier one, differs; or does so for some
  // answer to a reading that the run itself did not ask for.
  struct Parted {
    reference::ReadingKey key;
    std::string_view value;
    friend bool operator==(const Parted&, const Parted&) = default;
  };
  bool has_parted() const { return !parted_.empty(); }
  // Those since the last call.
  std::vector<Parted> take_parted() { return std::exchange(parted_, {}); }
  // No alternative is looked at from now on.
  void stop_watching();
  // How many are looked at.
  std::size_t others() const { return others_.size(); }

 private:
  struct Other;
  // Where the run went on from, or that it went past an end: before which item.
  struct Turn {
    std::size_t items;
    std::optional<reference::Position> stands_at;  // nothing: it went past an end
  };
  void watch_asked();
  void watch_asked_beside(Other& other);
  void add_other(const reference::Profile& beside, Parted what, const Other* neighbour,
                 std::size_t items);
  static bool agrees(Other& other, const reference::Item* item);
  bool is_parted(const Other& other) const;
  void take_turn(Turn turn);

  const reference::Profile& profile_;
  ProgramText program_;
  const AssignmentSet* watched_;
  Forking forking_;
  ProgramInput input_;
  reference::Expander expander_;
  std::size_t items_ = 0;
  std::vector<reference::ReadingKey> known_;  // that it has asked for
  std::vector<std::unique_ptr<Other>> others_;
  std::vector<Turn> turns_;
  std::vector<Parted> parted_;
};

}  // namespace gonogo::oracle
