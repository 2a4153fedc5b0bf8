// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/round_times.hpp"

#include "campaign/encoding.hpp"
#include "oracle/records/input_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>

namespace gonogo::hunt {
namespace {

using Json = nlohmann::ordered_json;

std::string file_in(const std::string& folder) {
  return folder + "/rounds.jsonl";
}

// What a kill leaves of the line that was being written.
bool ends_within_a_line(const std::string& path) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in || in.tellg() <= 0) return false;
  in.seekg(-1, std::ios::end);
  return in.get() != '\n';
}

std::int64_t seconds_of(std::chrono::system_clock::time_point time) {
  return std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
}

}  // namespace

void append_round_time(const std::string& folder, const RoundTime& time) {
  const Json line = {{"round", time.round},
                     {"ended", seconds_of(time.ended)},
                     {"seconds", fmt::format("{:.3f}", time.took.count())},
                     {"programs", time.programs}};
  const bool is_torn = ends_within_a_line(file_in(folder));
  std::ofstream out(file_in(folder), std::ios::binary | std::ios::app);
  out << (is_torn ? "\n" : "") + oracle::dump(line) + "\n";
  out.flush();
  if (!out) throw std::system_error(errno, std::generic_category(), file_in(folder));
}

std::vector<RoundTime> read_round_times(const std::string& folder) {
  std::map<std::size_t, RoundTime> rounds;
  std::ifstream in = oracle::open_regular(file_in(folder));
  for (std::string text; std::getline(in, text);) {
    const Json line = Json::parse(text, nullptr, false);
    if (!line.is_object()) continue;
    try {
      RoundTime time;
      time.round = line.at("round").get<std::size_t>();
      time.ended = std::chrono::system_clock::time_point(
          std::chrono::seconds(line.at("ended").get<std::int64_t>()));
      time.took = std::chrono::duration<double>(std::stod(line.at("seconds").get<std::string>()));
      time.programs = line.at("programs").get<std::size_t>();
      rounds[time.round] = time;
    } catch (const std::exception&) {
      continue;  // of another kind
    }
  }
  std::vector<RoundTime> times;
  for (const auto& [round, time] : rounds) times.push_back(time);
  return times;
}

}  // namespace gonogo::hunt
