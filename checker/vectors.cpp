// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/vectors.hpp"

#include <map>
#include <set>

#include "checker/coherence.hpp"
#include "checker/form.hpp"

namespace gonogo::checker {
namespace {

class Report {
 public:
  explicit Report(std::FILE* out) : out_(out) {}
  void fault(const std::string& sentence) {
    std::fprintf(out_, "fault      %s\n", sentence.c_str());
    ++faults_;
  }
  void undecided(const std::string& reason) { ++undecided_[reason]; }
  void print_undecided() const {
    for (const auto& [reason, count] : undecided_) {
      std::fprintf(out_, "undecided  %zu times: %s\n", count, reason.c_str());
    }
  }
  std::size_t faults() const { return faults_; }

 private:
  std::FILE* out_;
  std::size_t faults_ = 0;
  std::map<std::string, std::size_t> undecided_;
};

}  // namespace

int check_vectors(const std::string& folder, std::FILE* out) {
  const Corpus corpus(folder);
  Report report(out);
  for (const std::string& fault : corpus.faults()) report.fault(fault);
  const std::set<std::string> retired(corpus.retired().begin(), corpus.retired().end());
  for (const Corpus::File& file : corpus.files()) {
    for (const std::string& fault : form_faults(parse_json(file.text), corpus.version())) {
      report.fault(file.name + ": " + fault);
    }
  }
  std::size_t cases = 0;
  std::size_t expectations = 0;
  std::size_t records = 0;
  std::size_t half_told = 0;
  std::size_t enclosed_arcs = 0;
  corpus.for_each([&](const std::string& id, const Topic&) {
    ++cases;
    if (retired.contains(id)) report.fault(id + ": This id is retired.");
    try {
      const Vector vector = corpus.read(id);
      const Coherence found = coherence_of(vector);
      for (const std::string& sentence : found.faults) report.fault(id + ": " + sentence);
      for (const std::string& sentence : found.undecided) report.undecided(sentence);
      if (!found.undecided.empty()) ++half_told;
      enclosed_arcs += found.enclosed_arcs;
      expectations += vector.expect.size();
      for (const Expectation& one : vector.expect) records += one.records.size();
    } catch (const Fault& fault) {
      report.fault(id + ": " + fault.what());
    }
  });
  std::fprintf(out, "corpus %s, sha256 %s\n", corpus.version().c_str(), corpus.sha256().c_str());
  report.print_undecided();
  std::fprintf(out, "%zu arcs between enclosed points: their radii are equal within 1e-12 mm^2\n",
               enclosed_arcs);
  std::fprintf(out,
               "%zu vectors, %zu expectations, %zu records: %zu faults, %zu vectors in part "
               "undecided\n",
               cases, expectations, records, report.faults(), half_told);
  if (report.faults() > 0) return 1;
  return cases == 0 ? 3 : 0;
}

}  // namespace gonogo::checker
