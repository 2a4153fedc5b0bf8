// SPDX-License-Identifier: GPL-3.0-or-later
#include "short_form.hpp"

#include <map>

namespace gonogo::expanders::testing {
namespace {

std::string number_after(const std::string& record, const std::string& key,
                         const std::string& otherwise) {
  const std::size_t at = record.find(" " + key + "=");
  if (at == std::string::npos) return otherwise;
  const std::size_t begin = at + key.size() + 2;
  return record.substr(begin, record.find(' ', begin) - begin);
}

}  // namespace

std::vector<std::string> short_form(const Outcome& outcome) {
  std::vector<std::string> texts;
  std::map<std::string, std::string> place{{"x", "0"}, {"y", "0"}, {"z", "0"}};
  for (const std::string& record : outcome.records) {
    if (record.starts_with("end") || record == "m 2") continue;
    if (record.starts_with("m ")) {
      texts.push_back("M" + record.substr(2));
    } else if (record.starts_with("dwell ")) {
      texts.push_back("D" + record.substr(6));
    } else {
      for (auto& [axis, at] : place) at = number_after(record, axis, at);
      std::string text = (record[0] == 'r'   ? "R"
                          : record[0] == 'f' ? "F"
                                             : "T") +
                         place["x"] + "," + place["y"] + "," + place["z"];
      if (record[0] == 't') text += "@" + number_after(record, "lead", "");
      texts.push_back(text);
    }
  }
  if (outcome.alarms != 0) {
    texts.emplace_back("alarm");
    texts.push_back(outcome.alarm);
  }
  return texts;
}

}  // namespace gonogo::expanders::testing
