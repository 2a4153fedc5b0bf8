// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/verdict_report.hpp"

namespace gonogo::checker {

void VerdictReport::say(const char* what, const std::string& where,
                        const std::string& sentence) const {
  std::fprintf(out_, "%s  %s: %s\n", what, where.c_str(), sentence.c_str());
}

void VerdictReport::file_fault(const std::string& sentence) {
  say("file", options_.results, sentence);
  ++file_faults_;
}

void VerdictReport::corpus_fault(const std::string& sentence) {
  say("corpus", options_.corpus, sentence);
  ++file_faults_;
}

void VerdictReport::differs(const std::string& id, const std::string& sentence) {
  say("differs", id, sentence);
  ++differing_;
}

std::size_t VerdictReport::derived(Derived::Kind kind) const {
  const auto found = derived_.find(kind);
  return found == derived_.end() ? 0 : found->second;
}

int VerdictReport::summary(std::size_t cases, bool is_incomplete) const {
  const std::size_t go = derived(Derived::Kind::go);
  const std::size_t no_go = derived(Derived::Kind::no_go);
  const std::size_t gap = derived(Derived::Kind::gap);
  std::size_t left = 0;
  for (const auto& [reason, count] : left_out_) left += count;
  std::fprintf(out_, "%zu cases: %zu verdicts derived again (%zu GO, %zu NO-GO, %zu not covered), ",
               cases, go + no_go + gap, go, no_go, gap);
  std::fprintf(out_, "%zu differ, %zu not decided here\n", differing_, left);
  for (const auto& [reason, count] : left_out_) {
    std::fprintf(out_, "  %6zu  %s\n", count, reason.c_str());
  }
  if (file_faults_ > 0) std::fprintf(out_, "%zu things do not hold of the file\n", file_faults_);
  if (differing_ > 0) return 1;
  if (is_incomplete) return 3;
  if (file_faults_ > 0) return 1;
  return is_unproven_ || go + no_go == 0 ? 3 : 0;
}

}  // namespace gonogo::checker
