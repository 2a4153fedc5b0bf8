// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory that comes to its end while a file is read.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "campaign/known_failures.hpp"
#include "campaign/results_reader.hpp"
#include "capture/captured_trace.hpp"
#include "capture/sample_reader.hpp"
#include "corpus/io/corpus.hpp"
#include "publish/evidence/verify_cases.hpp"
#include "tests/hostile/every_failure.hpp"

namespace gonogo::hostile {
namespace {

using namespace oracle;

class AllocationFailureInFiles : public testing::Test {
 protected:
  AllocationFailureInFiles()
      : folder_(testing::TempDir() + "gonogo-allocation-failure-" + std::to_string(::getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~AllocationFailureInFiles() override { std::filesystem::remove_all(folder_); }
  std::string write(const char* name, std::string_view text) const {
    std::string path = folder_ + "/" + name;
    std::ofstream(path) << text;
    return path;
  }

  const std::string& folder() const { return folder_; }

 private:
  std::string folder_;
};

TEST_F(AllocationFailureInFiles, LeavesResultsRight) {
  std::string text =
      R"({"format":2,"gonogo":"0.1.0","subject":{"spec":"pipe:./acme","features":["m"]},"argv":["certify"]})"
      "\n";
  Sha256 hash;
  for (int i = 0; i < 20; ++i) {
    const std::string line =
        fmt::format(R"({{"id":"a.{:02}","dialect":"rs274","verdict":"pass-exact"}})", i);
    hash.update(line + "\n");
    text += line + "\n";
  }
  text += R"({"totals":{"pass-exact":20},"cases":20,"sha256":")" + hash.hex() + "\"}\n";
  const std::string path = write("results.jsonl", text);
  try_every_failure<ResultsError>([&] {
    ResultsReader reader(path);
    std::string answer = reader.header().dump();
    for (CaseHead head; reader.next(head);) answer += head.id + head.verdict;
    return answer + (reader.footer() ? reader.footer()->dump() : "no footer");
  });
}

TEST_F(AllocationFailureInFiles, LeavesVectorsRight) {
  const std::string path =
      std::string(GONOGO_SOURCE_DIR) + "/corpus/vectors/sinumerik802s/found.json";
  try_every_failure<CorpusError>(
      [&] { return vector_file_text(kUnreleased, read_vector_file(path)); });
}

TEST_F(AllocationFailureInFiles, LeavesSamplesRight) {
  const std::string path =
      write("samples.csv",
            "t,x,z\n0,50,5\n0.004,49.9000000000000000000000000000000000000000,5\nalarm,PS0061,3\n");
  try_every_failure<SampleFault>([&] {
    SampleReader reader(path);
    std::string answer;
    for (Sample sample; reader.next(sample);)
      answer += sample.time.text() + sample.at[reference::Axis::x].text();
    return answer + (reader.alarm() ? reader.alarm()->native : "no alarm");
  });
}

// Lines that grow, so that reading one takes memory.
constexpr std::string_view kLongTrace =
    R"({"k":"rapid","b":2,"to":{"z":"2"}})"
    "\n"
    R"({"k":"rapid","b":3,"to":{"x":"1.00000000000000000000000000000000","y":"2"}})"
    "\n";

TEST_F(AllocationFailureInFiles, LeavesACapturedTraceRight) {
  const std::string path = write("trace.jsonl", kLongTrace);
  try_every_failure<NoError>([&] {
    std::string answer;
    const RunEnd end = read_captured_trace(path, {}, [&](const reference::Record& record) {
      reference::append_json(record, answer);
      return true;
    });
    return answer + end.message;
  });
}

TEST_F(AllocationFailureInFiles, LeavesAVerdictOfACertificateRight) {
  write("a.1.jsonl", kLongTrace);
  Case test;
  test.id = "a.1";
  test.dialect = "rs274";
  test.program = "F100\nG0 Z2\nG0 X1 Y2\nM2\n";
  test.profile = std::get<reference::Profile>(reference::default_profile("rs274"));
  const auto header =
      ResultsReader::Json::parse(R"({"subject":{"spec":"pipe:./acme","features":["blocks"]}})");
  const auto line = ResultsReader::Json::parse(
      R"({"id":"a.1","dialect":"rs274","verdict":"pass-exact","coordinates":{"exact":3}})");
  const auto work = [&] {
    evidence::VerdictsAgain verdicts(header, folder(), {});
    verdicts.take(line, &test);
    evidence::Findings findings;
    verdicts.tell(findings);
    return findings.take().front().sentence;
  };
  ASSERT_EQ(work(), "Verdicts derived again, all the same: 1 from its trace.");
  try_every_failure<ResultsError>(work);
}

// By comparison: the JSON library, which writes profiles, aborts where an object in an object
// cannot be made.
template <typename Read>
void try_profile(Read read) {
  const reference::ProfileResult right = read();
  ASSERT_TRUE(std::holds_alternative<reference::Profile>(right));
  try_every_failure<NoError>([&] {
    const reference::ProfileResult now = read();
    if (const auto* error = std::get_if<reference::ProfileError>(&now)) return error->message;
    return std::string(std::get<reference::Profile>(now) == std::get<reference::Profile>(right)
                           ? "right"
                           : "another");
  });
}

TEST(AllocationFailureInTexts, LeavesAProfileRight) {
  try_profile([] {
    return reference::profile_from_toml(
        "dialect = \"rs274\"\ntools = {\"1\" = {radius = \"5\"}}\n[initial]\nx = \"1\"\n"
        "[readings]\n\"ngc.arc-tolerance\" = \"linuxcnc\"\n");
  });
  try_profile([] {
    return reference::profile_from_json(
        R"({"dialect":"rs274","initial":{"x":"1"},"offsets":{"G54":{"x":"1.5"}},"tools":{"1":{"radius":"2"}}})");
  });
}

TEST(AllocationFailureInTexts, LeavesKnownFailuresRight) {
  const char* const toml =
      "[[cause]]\nreason = \"chords\"\n[[cause.failure]]\ncases = [\"a.1\", \"b.*\"]\nverdict = "
      "\"fail.order\"\nflaky = \"1 of 5\"\n";
  try_every_failure<NoError>([&] {
    const auto read = known_causes_from_toml(toml);
    const auto* fault = std::get_if<FileFault>(&read);
    return fault != nullptr ? fault->message
                            : known_causes_text(std::get<std::vector<KnownCause>>(read));
  });
}

}  // namespace
}  // namespace gonogo::hostile
