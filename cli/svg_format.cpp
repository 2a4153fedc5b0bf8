// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/formats.hpp"

#include <fmt/format.h>

#include "cli/exit_code.hpp"
#include "cli/program_file.hpp"
#include "publish/report/sheet.hpp"

namespace gonogo::cli {
namespace {

// Collects the path, as far as a sheet can show it, and draws it at the end.
class SvgSheet : public RecordFormat {
 public:
  SvgSheet(const reference::Profile& profile, std::string_view program_name,
           std::uint64_t named_block)
      : sampler_(profile.initial.at),
        program_name_(program_name),
        dialect_(profile.dialect),
        named_block_(named_block) {}

  void record(const reference::Record& record, std::string&) override {
    if (!cut_ && !sampler_.add(record)) {
      cut_ = true;
      sampler_.mark_cut();
    }
  }
  void alarm(const reference::AlarmReport& report, std::string&) override {
    const reference::Alarm& first = report.alarms.front();
    sampler_.add_end("alarm", report.block, reference::clause_name(first.clause), first.message);
  }
  void not_covered(const reference::NotCovered& outside, std::string&) override {
    sampler_.add_end("not-covered", outside.block, "", outside.message);
  }
  void places(std::uint64_t block, const reference::CyclePlaces& places) override {
    if (!cut_) sampler_.add_names(block, places);
  }
  void finish(std::string& out) override {
    const oracle::report::Path path = sampler_.take();
    if (named_block_ != 0 && oracle::report::names_in(path, named_block_).empty()) {
      throw UsageError(fmt::format("--block {0}: line {0} runs no cycle whose points have names.",
                                   named_block_));
    }
    oracle::report::Sheet sheet;
    sheet.title = program_name_;
    sheet.dialect = dialect_;
    sheet.lathe = oracle::report::is_lathe(dialect_);
    sheet.reference = &path;
    sheet.block = named_block_;
    out += oracle::report::svg_sheet(sheet);
  }

 private:
  oracle::report::PathSampler sampler_;
  std::string program_name_;
  std::string dialect_;
  std::uint64_t named_block_;
  bool cut_ = false;
};

}  // namespace

std::unique_ptr<RecordFormat> make_svg_format(const reference::Profile& profile,
                                              std::string_view program_name,
                                              std::uint64_t named_block) {
  return std::make_unique<SvgSheet>(profile, program_name, named_block);
}

}  // namespace gonogo::cli
