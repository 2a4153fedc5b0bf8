// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/selection.hpp"
#include "cli/certify_run.hpp"
#include "cli/gauge.hpp"
#include "cli/options.hpp"
#include "cli/program_file.hpp"
#include "cli/version.hpp"
#include "publish/evidence/certificate_files.hpp"

namespace gonogo::cli {
namespace {

// The hash of a file; nothing without one.
std::string sha256_of(const std::string& path) {
  if (path.empty()) return {};
  return oracle::evidence::sha256_of_text(read_file(path, "a file"));
}

}  // namespace

oracle::ResultsHeader results_header(const CertifyOptions& options, const std::string& subject,
                                     const oracle::Corpus& corpus,
                                     const oracle::CampaignOptions& campaign,
                                     const oracle::SubjectInfo& info) {
  oracle::ResultsHeader header;
  header.version = kVersion;
  header.commit = gauge_commit();
  header.program_sha256 = gauge_sha256();
  header.corpus_version = corpus.version();
  header.corpus_sha256 = corpus.sha256();
  header.subject_spec = subject;
  header.subject = info;
  if (campaign.profile) {
    header.profile = reference::profile_json(*campaign.profile);
    header.machine = campaign.profile->dialect;
    header.machine_keys = campaign.profile_keys;
  }
  header.readings = options.readings;
  header.dialects = options.dialects;
  header.only = options.only;
  header.cases = options.cases;
  header.cycles = options.cycles;
  header.clauses = options.clauses;
  header.known_failures_sha256 = sha256_of(options.known_failures);
  header.alarm_map_sha256 = sha256_of(options.alarm_map);
  const oracle::Grants& grants = campaign.grants;
  if (grants.tolerance) header.tolerance = grants.tolerance->text();
  if (grants.chord) header.chord = grants.chord->text();
  if (grants.feed_resolution) header.feed_resolution = grants.feed_resolution->text();
  header.strict = grants.strict;
  header.sandbox = sandbox_name(campaign.limits, subject);
  if (campaign.limits.capture.blend) header.blend = campaign.limits.capture.blend->text();
  if (const auto percent =
          decimal_option(options.limits.feed_tolerance, "--feed-tolerance", "percent")) {
    header.feed_tolerance = percent->text();
  }
  header.show_ids = campaign.limits.show_ids;
  header.seed = campaign.seed;
  header.capped = oracle::capped_declarations(campaign, info);
  header.shard = options.shard;
  header.argv = options.argv;
  return header;
}

}  // namespace gonogo::cli
