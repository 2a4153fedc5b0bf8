// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign_testing.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "reference/expander.hpp"

namespace gonogo::oracle {
namespace fs = std::filesystem;

namespace {

void write_corpus(const Scratch& scratch, int cases) {
  using Json = nlohmann::ordered_json;
  constexpr int kCasesOfAFile = 10;
  Json files = Json::array();
  for (int first = 0; first < cases; first += kCasesOfAFile) {
    Json group = {{"gid", "g"},
                  {"features", Json::array({"basic"})},
                  {"clauses", Json::array()},
                  {"profile", Json::object()}};
    for (int i = first; i < std::min(cases, first + kCasesOfAFile); ++i) {
      char id[32];
      std::snprintf(id, sizeof id, "t.%06d", i);
      const std::string program = "G00 X" + std::to_string(2 * i) + " Z5\nM30\n";
      group["cases"].push_back(
          {{"id", id},
           {"comment", ""},
           {"program", program},
           {"expect",
            Json::array({Json::parse(expectation_json(expectation_of(Case().profile, program)))})},
           {"tags", {{"tway", Json::array()}, {"sign", Json::array()}}},
           {"provenance", "hand"}});
    }
    char name[64];
    std::snprintf(name, sizeof name, "vectors/gsk988ta/f%04d.json", first / kCasesOfAFile);
    files.push_back(name);
    scratch.write(std::string("corpus/") + name, Json{{"format", 1},
                                                      {"corpus", "1"},
                                                      {"dialect", "gsk988ta"},
                                                      {"cycle", "basic"},
                                                      {"groups", Json::array({group})}}
                                                     .dump());
  }
  scratch.write("corpus/manifest.json", Json{{"format", 1},
                                             {"version", "1"},
                                             {"license", "CC0-1.0"},
                                             {"files", files},
                                             {"retired", Json::array()}}
                                            .dump());
}

}  // namespace

Scratch::Scratch(int cases) {
  std::string name = (fs::temp_directory_path() / "gonogo-campaign-XXXXXX").string();
  folder_ = ::mkdtemp(name.data());
  if (cases > 0) write_corpus(*this, cases);
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Scratch::write(const std::string& name, const std::string& text) const {
  fs::create_directories(fs::path(path(name)).parent_path());
  std::ofstream(path(name), std::ios::binary) << text;
}

std::string Scratch::read(const std::string& name) const {
  std::ifstream file(path(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

namespace {

class Fake : public Subject {
 public:
  explicit Fake(FakeSubject fake) : fake_(std::move(fake)) {
    if (fake_.info) info_ = *fake_.info;
    info_.name = "fake";
    if (fake_.info) return;
    info_.everything = true;
    info_.features = {"blocks"};
    info_.max_in_flight = fake_.window;
  }
  const SubjectInfo& info() const override { return info_; }
  void configure(const reference::Profile& profile) override { profile_ = profile; }
  void renew() override { runs_ = 0; }
  std::optional<RunEnd> finish() override {
    if (!fake_.breaks_at_end) return std::nullopt;
    return RunEnd::of(RunEnd::Kind::crash, "It broke down at its end.");
  }
  RunEnd run(std::string_view id, std::string_view program, const RecordSink& sink) override {
    ++runs_;
    if (fake_.act) {
      if (auto end = fake_.act(id, runs_)) return *std::move(end);
    }
    grammar::MemorySource bytes(program);
    grammar::LineSource lines(bytes);
    reference::Expander expander(profile_, lines, reference::OpenPaths::shown);
    while (const reference::Item* item = expander.next()) {
      const auto* record = std::get_if<reference::Record>(item);
      if (record == nullptr) continue;
      reference::Record sent = *record;
      if (fake_.alter) fake_.alter(id, sent);
      sink(sent);
    }
    RunEnd end = RunEnd::of(fake_.end, {});
    end.microseconds = fake_.microseconds;
    return end;
  }

 private:
  FakeSubject fake_;
  SubjectInfo info_;
  reference::Profile profile_;
  int runs_ = 0;
};

}  // namespace

SubjectMaker fake_maker(FakeSubject fake) {
  return [fake = std::move(fake)] { return std::make_unique<Fake>(fake); };
}

FakeSubject acting(decltype(FakeSubject::act) act) {
  FakeSubject fake;
  fake.act = std::move(act);
  return fake;
}

RunEnd ended(RunEnd::Kind kind) {
  return RunEnd::of(kind, "It ended so.");
}

CaseResult passed(std::string id) {
  CaseResult result;
  result.id = std::move(id);
  result.dialect = "gsk988ta";
  result.cycle = "basic";
  result.verdict.kind = VerdictKind::pass_exact;
  result.microseconds = 7;
  return result;
}

CaseFacts facts(std::string id, VerdictKind verdict, std::string dialect) {
  CaseFacts made;
  made.head.id = std::move(id);
  made.head.dialect = std::move(dialect);
  made.verdict = verdict;
  return made;
}

RunAnswer answer(const std::vector<CaseFacts>& cases, const std::vector<std::string>& stale) {
  Tally tally;
  for (const CaseFacts& one : cases) tally.add(one);
  return tally.finish(stale);
}

CampaignOptions options_of(int jobs) {
  CampaignOptions options;
  options.jobs = jobs;
  return options;
}

std::string results_of(const Scratch& scratch, const FakeSubject& fake,
                       const CampaignOptions& options, const std::string& name) {
  const SubjectMaker maker = fake_maker(fake);
  const Corpus corpus(scratch.path("corpus"));
  ResultsHeader header;
  header.seed = options.seed;
  const SubjectInfo info = maker()->info();
  header.subject.everything = info.everything;
  header.subject.dialects = info.dialects;
  header.shard = std::to_string(options.shard) + "/" + std::to_string(options.shards);
  ResultsWriter writer(scratch.path(name), header);
  const CampaignEnd end = run_campaign(
      corpus, options, maker, [&](const CaseResult& result) { writer.add(result); }, nullptr);
  ResultsWriter::Ending ending;
  ending.left_out = end.left_out;
  ending.stale = end.stale;
  ending.is_shard = options.shards > 1;
  if (options.alarm_map && options.is_whole()) ending.alarms = options.alarm_map->natives();
  return footer_line(writer.close(ending));
}

}  // namespace gonogo::oracle
