// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the generators of all dialects of letter-address programs share: words in least increments,
// blocks as lines of text, and one thing in a block put wrong.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/generate/generator.hpp"
#include "reference/code.hpp"

namespace gonogo::generate {

// One thing put wrong in a block.
enum class Fault { missing, twice, sign, zero, stray, far };

class ProgramWriter {
 public:
  ProgramWriter(const ProgramWriter&) = delete;
  ProgramWriter& operator=(const ProgramWriter&) = delete;

 protected:
  using Words = std::vector<std::string>;
  using Treatment = reference::Treatment;

  // `settings` must outlive the writer; `distribution` may be null.
  ProgramWriter(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                Distribution* distribution)
      : choices_(choices), settings_(settings), program_kind_(kind), distribution_(distribution) {}
  ~ProgramWriter() = default;

  // Decimals of the least increment of a length.
  virtual int decimals() const = 0;
  // An axis word that the block did not ask for.
  virtual std::string stray_word() = 0;
  // Whether the word may have this fault; false where the reading leaves open what follows, or
  // where motions would come by the thousands.
  virtual bool may_have(Fault fault, const std::string& word) const = 0;
  // Letters of words that are no lengths.
  virtual std::string_view letters_of_codes() const { return "GMNFSTOHDL"; }
  // A word as it stands in the text.
  virtual std::string printed(const std::string& word) { return word; }
  // What stands before and behind the words of a block: a slash and a number, comments.
  virtual std::string head();
  virtual std::string tail();
  // The word with the sign of its value turned, or with another value.
  virtual std::string negated(const std::string& word) const;
  virtual std::string with_value(const std::string& word, const char* value) const;
  // A length far out, but in the domain (D-DOM-02), or beyond what the word may have.
  virtual const char* far_out() const { return "9000"; }

  void count(const std::string& name) {
    if (distribution_ != nullptr) ++(*distribution_)[name];
  }
  std::int64_t unit() const;  // increments of one mm or inch
  // A length at random from 0 on, in least increments.
  std::int64_t length(std::int64_t most_units);
  // This length; in a tiny program as often a few least increments.
  std::int64_t length_of(std::int64_t increments);
  // 12500 -> "X12.5" where there are three decimals.
  std::string word(char address, std::int64_t increments) const;
  std::string feed_word();

  // How many blocks come after the head, where the dialect's own programs have so many at most.
  std::int64_t number_of_blocks(int own_most) {
    return choices_.between(1, settings_.most_blocks.value_or(own_most));
  }
  // Whether something is put wrong here, as in one of so many places.
  bool puts_wrong(std::uint32_t one_in) {
    return program_kind_ == ProgramKind::near_invalid && choices_.one_in(one_in);
  }
  // Whether the block is one that a rule refuses, as in one of so many places; nowhere, where the
  // settings want none.
  bool errs(std::uint32_t one_in) { return settings_.refused && choices_.one_in(one_in); }
  // Whether a value meets one of its limits here, as in one of so many places.
  bool meets_limit(std::uint32_t one_in) {
    return program_kind_ == ProgramKind::boundary && choices_.one_in(one_in);
  }
  // A code or name of the dialect's table, as it stands alone.
  std::string code_that_is(reference::Treatment treatment);
  // Any alternative of any reading; now and then of several.
  void choose_readings();
  // Feed, motion and plane of the profile before the first block.
  void choose_initial_modes();

  // Called when a block does not say what the dialect's writer meant.
  virtual void on_fault() {}

  // Writes the block; with one thing put wrong or on a boundary, as the kind of program says.
  void put(Words words);

  Choices& choices_;
  const GeneratorSettings& settings_;
  reference::Profile profile_;
  std::string text_;

 private:
  void spoil(Words& words);
  void move_to_boundary(Words& words);

  ProgramKind program_kind_;
  Distribution* distribution_;
};

}  // namespace gonogo::generate
