// SPDX-License-Identifier: GPL-3.0-or-later
//
// One worker of a campaign: its subject, and the repetitions that a verdict other than GO needs.
#pragma once

#include "campaign/campaign.hpp"
#include "campaign/trace_file.hpp"
#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

// Behind the message of a departure whose second run came to no answer.
inline constexpr std::string_view kNoAnswerAgain = " A fresh process gave no answer in time.";

class CaseJudge {
 public:
  // `options` and `make_subject` must outlive it. Throws SubjectUnusable.
  CaseJudge(const CampaignOptions& options, const SubjectMaker& make_subject);
  CaseJudge(const CaseJudge&) = delete;
  CaseJudge& operator=(const CaseJudge&) = delete;

  // How many cases are worth announcing, the one that is judged next among them.
  std::size_t window() const;
  const SubjectInfo& info() const { return subject_->info(); }
  // The case that is judged next.
  void prepare(const Case& test);
  // Announces a case that follows the last one announced to the subject. False when the subject
  // cannot be known yet: the case has another profile than the one that was prepared.
  bool announce(const Case& test);
  CaseResult judge(const Case& test);
  // After the last case, which was no NO-GO: ends the subject. If it breaks down in that, the
  // breakdown belongs to this case, since no other follows.
  void finish(const Case& test, CaseResult& result);

 private:
  struct Attempt;
  std::optional<std::string> undeclared_feature(const Case& test) const;
  // `number`: of the runs of this case, from 1. Throws ResultsUnwritable.
  Attempt run(Subject& subject, const Case& test, const Tolerances& tolerances, int number) const;
  bool is_claimed(const Case& test, const RunEnd& end) const;
  void interpret_skip(const Case& test, Attempt& attempt) const;
  static bool settle_memory(Attempt& attempt, Attempt& again);
  bool settle_flaky(const Case& test, const Tolerances& tolerances, Attempt& attempt,
                    CaseResult& result);
  void confirm(const Case& test, const Tolerances& tolerances, Attempt& attempt,
               CaseResult& result);
  void confirm_timeout(const Case& test, const Tolerances& tolerances, Attempt& attempt,
                       CaseResult& result);
  static void keep_path(const Case& test, const Attempt& attempt, CaseResult& result);
  void keep_evidence(const Case& test, const Tolerances& tolerances, const Attempt& attempt,
                     CaseResult& result) const;
  std::unique_ptr<Subject> make() const;
  // The second subject, in a process of its own that has run nothing yet.
  Subject& fresh_subject(const reference::Profile& profile);

  const CampaignOptions& options_;
  const SubjectMaker& make_subject_;
  const KnownFailures known_failures_;
  std::unique_ptr<Subject> subject_;
  std::unique_ptr<Subject> second_;            // made when it is first needed
  std::optional<reference::Profile> profile_;  // that was prepared
  std::string profile_text_;                   // the same as JSON
};

}  // namespace gonogo::oracle
