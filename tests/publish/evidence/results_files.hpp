// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results files for the tests of what is made of them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gonogo::oracle {

// A folder that goes when the test ends.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::string write(const std::string& name, std::string_view text) const;
  std::string read(const std::string& name) const;
  bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }

 private:
  std::filesystem::path path_;
};

inline constexpr std::string_view kHeaderLine =
    R"({"format":1,"gonogo":"0.1.0","corpus":{"version":"2026.6.0","sha256":"c0ffee"},)"
    R"("subject":{"spec":"pipe:./acme --fast","name":"acme","version":"3.2","numeric":{"kind":"exact"},)"
    R"("features":["blocks","m"]},"profile":{},"tolerance":null,"chord":null,"seed":0,"shard":"1/1",)"
    R"("argv":["certify","--subject","pipe:./acme --fast"]})";

// A whole file: header, these case lines, and a footer with their totals and hash.
std::string results_text(const std::vector<std::string>& cases, const std::string& decision = "GO");

}  // namespace gonogo::oracle
