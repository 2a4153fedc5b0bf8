// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run must have: from its header and the corpus alone, not from what the subject did.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checker/corpus.hpp"
#include "checker/selection.hpp"

namespace gonogo::checker {

// In what the header differs from the command line that it names, that of a merged run from those
// of its shards: sentences.
std::vector<std::string> header_faults(const Json& header);
// Whether there are programs that no command line of the header asks for: a sentence, or empty.
// `fresh`: the key of the footer. Throws Fault.
std::string fresh_fault(const Json& header, const Json& fresh);

class Roll {
 public:
  // `header` must outlive it. Throws Fault.
  explicit Roll(const Json& header);

  bool takes(const std::string& id, const Topic& topic) const {
    return selection_.takes(id, topic);
  }
  // The profile of the vector with what the certifier's sets; nothing: they contradict each other,
  // and the run leaves the case out.
  std::optional<Json> profile_of(const std::string& dialect, const Json& profile) const;
  // Whether two profiles say the same; a reading that is the default may stand there or not.
  bool is_same_machine(Json one, Json other) const;
  // Throws Fault for a line that says another thing of its case than the vector does.
  void check_words(const Json& line, const Vector& vector) const;
  // A feature that the case needs and the subject does not declare; empty: there is none.
  std::string undeclared(const Vector& vector) const;
  // Whether the subject says at all what it has.
  bool declares() const { return dialects_ != nullptr; }
  bool is_recorded() const { return is_recorded_; }
  bool has_feature(const std::string& name) const;

 private:
  bool is_set(const Json& profile, const Json& key) const;

  Selection selection_;
  const Json& machine_;          // keys of the certifier's profile
  std::string machine_dialect_;  // empty: there is no such profile
  const Json* sets_ = nullptr;   // the keys that it sets, to the default or not
  const Json* readings_ = nullptr;
  const Json* dialects_ = nullptr;  // the features declared of each; null: nothing is declared
  std::vector<std::string> features_;
  bool is_recorded_ = false;
};

}  // namespace gonogo::checker
