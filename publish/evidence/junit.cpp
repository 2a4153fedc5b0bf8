// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/junit.hpp"

#include <fmt/format.h>

#include <system_error>

#include "oracle/records/input_file.hpp"
#include "oracle/records/output_file.hpp"
#include "publish/evidence/text.hpp"
#include "publish/report/escape.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

using report::markup_text;

namespace {

std::string seconds(std::uint64_t microseconds) {
  constexpr std::uint64_t kSecond = 1'000'000;
  return fmt::format("{}.{:06}", microseconds / kSecond, microseconds % kSecond);
}

std::string property(std::string_view name, const std::string& value) {
  if (value.empty()) return {};
  return fmt::format("<property name=\"{}\" value=\"{}\"/>\n", name, xml_attribute(value));
}

std::string suite_properties(const Json& header) {
  const Json subject = header.value("subject", Json::object());
  const Json corpus = header.value("corpus", Json::object());
  return "<properties>\n" + property("gonogo", report::text_of(header, "gonogo")) +
         property("subject", report::text_of(subject, "spec")) +
         property("subject.name", report::text_of(subject, "name")) +
         property("subject.version", report::text_of(subject, "version")) +
         property("corpus.version", report::text_of(corpus, "version")) +
         property("corpus.sha256", report::text_of(corpus, "sha256")) +
         property("shard", report::text_of(header, "shard")) + "</properties>\n";
}

// <failure type="fail.feed" message="...">facts</failure>
std::string element(std::string_view tag, const CaseRow& facts, const Finding* finding) {
  const std::string body =
      finding_text(facts, "") +
      (finding == nullptr ? std::string() : "finding    " + finding->text() + "\n");
  return fmt::format("<{} type=\"{}\" message=\"{}\">{}</{}>", tag, facts.verdict(),
                     xml_attribute(facts.message), markup_text(body), tag);
}

std::string skipped(const CaseRow& facts) {
  std::string verdict(facts.verdict());
  const std::string& why = facts.gap.empty() ? facts.departure : facts.gap;
  if (!why.empty()) verdict += fmt::format(" ({})", why);
  if (!facts.known.empty()) verdict += fmt::format(", known: {}", facts.known);
  const std::string reason =
      facts.message.empty() ? verdict : fmt::format("{}: {}", verdict, facts.message);
  return fmt::format("<skipped message=\"{}\"/>", xml_attribute(reason));
}

}  // namespace

JunitMark junit_mark(const CaseRow& facts) {
  switch (facts.kind) {
    case VerdictKind::crash:
    case VerdictKind::timeout:
    case VerdictKind::out_of_memory:
    case VerdictKind::protocol:
    case VerdictKind::oracle_error:
      return JunitMark::error;
    case VerdictKind::skip:
    case VerdictKind::advice:
    case VerdictKind::xfail:
    case VerdictKind::oracle_gap:
      return JunitMark::skipped;
    default:
      return facts.decision() == Decision::go ? JunitMark::passed : JunitMark::failure;
  }
}

void JunitWriter::Counts::add(JunitMark mark, std::uint64_t time) {
  ++tests;
  microseconds += time;
  if (mark == JunitMark::failure) ++failures;
  if (mark == JunitMark::error) ++errors;
  if (mark == JunitMark::skipped) ++skipped;
}

std::string JunitWriter::Counts::attributes() const {
  return fmt::format(R"(tests="{}" failures="{}" errors="{}" skipped="{}" time="{}")", tests,
                     failures, errors, skipped, seconds(microseconds));
}

JunitWriter::JunitWriter(std::filesystem::path path, const Json& header)
    : path_(std::move(path)), properties_(suite_properties(header)) {}

JunitWriter::~JunitWriter() {
  for (auto& [dialect, suite] : suites_) {
    suite.out.close();
    std::error_code ignored;
    std::filesystem::remove(suite.path, ignored);
  }
}

JunitWriter::Suite& JunitWriter::suite(const std::string& dialect) {
  auto [place, added] = suites_.try_emplace(dialect);
  Suite& suite = place->second;
  if (added) {
    suite.path = path_.string() + fmt::format(".{}.part", suites_.size());
    open_anew(suite.path, suite.out);
    if (!suite.out) {
      throw std::system_error(errno, std::generic_category(),
                              suite.path.string() + " cannot be written");
    }
  }
  return suite;
}

void JunitWriter::add(const CaseRow& facts, const Finding* finding) {
  const JunitMark mark = junit_mark(facts);
  Suite& own = suite(facts.dialect);
  own.counts.add(mark, facts.microseconds);
  all_.add(mark, facts.microseconds);
  own.out << fmt::format("<testcase classname=\"{}.{}\" name=\"{}\" time=\"{}\"",
                         xml_attribute(facts.dialect), xml_attribute(facts.cycle),
                         xml_attribute(facts.id), seconds(facts.microseconds));
  if (mark == JunitMark::passed) {
    own.out << "/>\n";
    return;
  }
  const char* const tag = mark == JunitMark::failure ? "failure" : "error";
  own.out << '>' << (mark == JunitMark::skipped ? skipped(facts) : element(tag, facts, finding))
          << "</testcase>\n";
}

void JunitWriter::copy_suite(const std::string& dialect, Suite& suite, OutputFile& out,
                             const std::string& properties) const {
  suite.out.close();
  std::ifstream in = open_regular(suite.path);
  if (!suite.out || !in) {
    throw std::system_error(errno, std::generic_category(),
                            suite.path.string() + " cannot be written");
  }
  out.write(fmt::format("<testsuite name=\"{}\" {}>\n{}", xml_attribute(dialect),
                        suite.counts.attributes(), properties));
  std::string chunk(std::size_t{1} << 16, '\0');
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
    out.write(std::string_view(chunk).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  out.write("</testsuite>\n");
}

// The whole run's, in each suite: a reader of one sees what the others were.
std::string JunitWriter::properties(const RunState& state) const {
  const Json& headline = state.summary["headline"];
  std::string own = property("decision", state.decision) + property("head", state.head) +
                    property("judged", headline["judged"].dump()) +
                    property("advices", headline["advices"].dump()) +
                    property("not-claimed", headline["notClaimed"].dump()) +
                    property("known-to-fail", headline["known"].dump());
  for (const Json& finding : state.summary["findings"]) {
    own += property("finding", report::text_of(finding, "line"));
  }
  constexpr std::string_view kEnd = "</properties>\n";
  return properties_.substr(0, properties_.size() - kEnd.size()) + own + std::string(kEnd);
}

// What is wrong with the run and with none of its cases, as a suite of its own.
std::string JunitWriter::run_suite(const RunState& state, const std::string& properties) {
  std::string tests;
  Counts counts;
  const auto put = [&](std::string_view name, std::string_view type, const std::string& message) {
    counts.add(JunitMark::error, 0);
    all_.add(JunitMark::error, 0);
    tests += fmt::format(
        "<testcase classname=\"run\" name=\"{}\" time=\"0.000000\"><error type=\"{}\" "
        "message=\"{}\"></error></testcase>\n",
        xml_attribute(name), type, xml_attribute(message));
  };
  if (!state.unfinished.empty()) put("whole", "incomplete", state.unfinished);
  for (const std::string& entry : state.stale) put(entry, "stale", stale_sentence(entry));
  if (tests.empty()) return {};
  return fmt::format("<testsuite name=\"run\" {}>\n{}{}</testsuite>\n", counts.attributes(),
                     properties, tests);
}

void JunitWriter::finish(const RunState& state) {
  const std::string properties = this->properties(state);
  const std::string of_run = run_suite(state, properties);
  OutputFile out(path_);
  out.write("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  out.write(fmt::format("<testsuites name=\"gonogo\" {}>\n", all_.attributes()));
  for (auto& [dialect, suite] : suites_) copy_suite(dialect, suite, out, properties);
  out.write(of_run);
  out.write("</testsuites>\n");
  out.commit();
}

}  // namespace gonogo::oracle::evidence
