// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the cases of a corpus as programs for a real controller, with a manifest that maps what
// comes back to the cases and names what was left out.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "capture/export_header.hpp"
#include "capture/program_extents.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::oracle {

struct ExportOptions {
  // X, Y, Z; mm as true lengths, X of a lathe as a radius. Nothing: anywhere.
  std::optional<std::array<std::array<Number, 2>, 3>> envelope;
  std::optional<Number> feed_max;  // mm/min
  std::string header;              // text that is put before each program's own header
  bool all_profiles = false;       // also those that need the machine set up otherwise
  bool expected = false;           // with what they have to do, and the comparer
  // For a lathe: the radius at which the work offset puts X0, mm. Nothing: X0 is the spindle's
  // axis, and programs that start there are left out, for their header would traverse to it.
  std::optional<Number> x_zero_at;
};

// What a manifest says of the run.
struct ExportTitle {
  std::string gonogo;
  std::string corpus_version;
  std::string corpus_sha256;
};

class Exporter {
 public:
  // Writes into `folder`, which must be empty or not be there; throws std::runtime_error with a
  // sentence when it is not.
  Exporter(std::string folder, ExportOptions options, ExportTitle title);
  // Writes the program of the case, or notes why not.
  void add(const Case& test);
  // Writes the manifest; returns the text for people.
  std::string finish();

 private:
  // Why the case is left out; empty when it is not.
  std::string_view obstacle(const Case& test, const Extents& extents) const;
  void write(const Case& test, const Extents& extents, const ExportHeader& header,
             const nlohmann::ordered_json& set_up);
  nlohmann::ordered_json manifest() const;

  std::filesystem::path folder_;
  ExportOptions options_;
  ExportTitle title_;
  std::uint64_t header_lines_ = 0;  // of the certifier's text
  std::size_t cases_ = 0, alarms_ = 0;
  std::string expected_;  // a line a program
  nlohmann::ordered_json programs_ = nlohmann::ordered_json::array();
  std::map<std::string, std::size_t> set_ups_;                // dialect and keys -> cases
  std::map<std::string, std::vector<std::string>> left_out_;  // reason -> ids
};

// "0..100,-50..50,-200..10"; nothing when it is not of that form.
std::optional<std::array<std::array<Number, 2>, 3>> envelope_of(const std::string& text);

}  // namespace gonogo::oracle
