// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the generators of all dialects of letter-address programs share: words in least increments,
// blocks as lines of text, and one thing in a block put wrong.
#pragma once

#include <string>
#include <vector>

#include "fuzz/generator.hpp"

namespace gonogo::fuzz {

// One thing put wrong in a block.
enum class Fault { missing, twice, sign, zero, stray, far };

class ProgramWriter {
 public:
  ProgramWriter(const ProgramWriter&) = delete;
  ProgramWriter& operator=(const ProgramWriter&) = delete;

 protected:
  using Words = std::vector<std::string>;

  // One block in `fault_one_in` is put wrong; 0: none. `distribution` may be null.
  ProgramWriter(Choices& choices, std::uint32_t fault_one_in, Distribution* distribution)
      : choices_(choices), fault_one_in_(fault_one_in), distribution_(distribution) {}
  ~ProgramWriter() = default;

  // Decimals of the least increment of a length.
  virtual int decimals() const = 0;
  // An axis word that the block did not ask for.
  virtual std::string stray_word() = 0;
  // Whether the word may have this fault; false where the reading leaves open what follows, or
  // where motions would come by the thousands.
  virtual bool may_have(Fault fault, const std::string& word) const = 0;
  // A word as it stands in the text.
  virtual std::string printed(const std::string& word) { return word; }
  // What stands before and behind the words of a block: a slash and a number, comments.
  virtual std::string head();
  virtual std::string tail();
  // The word with the sign of its value turned, or with another value.
  virtual std::string negated(const std::string& word) const;
  virtual std::string with_value(const std::string& word, const char* value) const;

  void count(const std::string& name) {
    if (distribution_ != nullptr) ++(*distribution_)[name];
  }
  std::int64_t unit() const;  // increments of one mm or inch
  // A length at random from 0 on, in least increments.
  std::int64_t length(std::int64_t most_units);
  // 12500 -> "X12.5" where there are three decimals.
  std::string word(char address, std::int64_t increments) const;
  std::string feed_word();

  // Called when a block was put wrong.
  virtual void on_fault() {}

  // Writes the block, now and then with one thing put wrong.
  void put(Words words);

  Choices& choices_;
  reference::Profile profile_;
  std::string text_;

 private:
  void spoil(Words& words);

  std::uint32_t fault_one_in_;
  Distribution* distribution_;
};

}  // namespace gonogo::fuzz
