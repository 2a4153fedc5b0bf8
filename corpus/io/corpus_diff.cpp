// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/corpus_diff.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "corpus/io/sha256.hpp"

namespace gonogo::oracle {
namespace {

struct Digest {
  std::string question;  // program and profile
  std::string answer;    // expectations
  std::string ends;      // their alarms, for people
};

std::string ends_of(const Case& test) {
  std::set<std::string> ends;
  for (const Expectation& expectation : test.expect) {
    for (const ExpectedAlarm& alarm : expectation.alarms) {
      ends.insert(fmt::format("{}@{}", name(alarm.alarm), alarm.block));
    }
    if (expectation.not_covered) ends.insert("not covered");
    if (expectation.alarms.empty() && !expectation.not_covered) ends.insert("end");
  }
  std::string text;
  for (const std::string& end : ends) text += (text.empty() ? "" : " ") + end;
  return text;
}

std::map<std::string, Digest> digests_of(const Corpus& corpus) {
  std::map<std::string, Digest> digests;
  corpus.for_each([&](const Case& test) {
    Sha256 question;
    question.update(test.dialect + reference::profile_json(test.profile));
    question.update(test.program);
    Sha256 answer;
    for (Expectation expectation : test.expect) {
      expectation.basis.reset();  // no subject is held to it
      answer.update(expectation_json(expectation));
    }
    digests[test.id] = {question.hex(), answer.hex(), ends_of(test)};
  });
  return digests;
}

}  // namespace

CorpusDiff diff(const Corpus& old_corpus, const Corpus& new_corpus) {
  const std::map<std::string, Digest> before = digests_of(old_corpus);
  const std::map<std::string, Digest> now = digests_of(new_corpus);
  CorpusDiff result;
  for (const auto& [id, digest] : now) {
    const auto found = before.find(id);
    if (found == before.end()) {
      result.added.push_back(id);
    } else if (found->second.question != digest.question) {
      result.reused.push_back(id);
    } else if (found->second.answer != digest.answer) {
      result.changed.push_back(id);
      if (found->second.ends != digest.ends) {
        result.changed_ends.push_back(
            fmt::format("{}: {}, now {}", id, found->second.ends, digest.ends));
      }
    }
  }
  for (const auto& [id, digest] : before) {
    if (now.contains(id)) continue;
    result.removed.push_back(id);
    if (!new_corpus.retired().contains(id)) result.not_retired.push_back(id);
  }
  return result;
}

}  // namespace gonogo::oracle
