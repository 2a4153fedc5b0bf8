// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo misbehave KIND: subjects of the self-test. Each speaks the pipe protocol and breaks one
// thing; `reference` is the reference itself and breaks nothing.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/commands.hpp"
#include "cli/formats.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "reference/expander.hpp"

namespace gonogo::cli {
namespace {

void send(const std::string& line) {
  Output output;
  output.text() = line + "\n";
  output.flush();
}

std::string start_reply() {
  return R"({"protocol":1,"subject":{"name":"selftest","version":"1"},"dialects":["gsk988ta"],)"
         R"("features":["blocks","m"],"numeric":{"kind":"exact"},"readings":["*"],"max_in_flight":1})";
}

// What the reference says of a program, as a reply.
std::string reference_reply(const reference::Profile& profile, const std::string& program,
                            long long seq) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  std::string records;
  std::string outcome = R"("outcome":"ok")";
  while (const reference::Item* item = expander.next()) {
    if (auto* record = std::get_if<reference::Record>(item)) {
      if (!records.empty()) records += ',';
      append_json(*record, records);
    } else if (auto* alarms = std::get_if<reference::AlarmReport>(item)) {
      const reference::Alarm& first = alarms->alarms.front();
      outcome = fmt::format(R"("outcome":"alarm","alarm":{{"native":"-","class":"{}","b":{}}})",
                            reference::name(first.alarm), alarms->block);
    } else if (std::holds_alternative<reference::NotCovered>(*item)) {
      outcome = R"("outcome":"skip","feature":"outside","message":"not covered")";
    }
  }
  return fmt::format(R"({{"seq":{},{},"records":[{}]}})", seq, outcome, records);
}

[[noreturn]] void flood(long long seq) {
  // Records without end, in parts, going to and fro.
  for (long long i = 0;; ++i) {
    send(fmt::format(
        R"({{"seq":{},"records":[{{"k":"rapid","b":1,"to":{{"x":"{}"}}}}],"more":true}})", seq,
        i % 2));
  }
}

class Misbehaviour {
 public:
  explicit Misbehaviour(std::string kind) : kind_(std::move(kind)) {}

  void run(const nlohmann::json& message) {
    const long long seq = message["seq"];
    const std::string program = message["program"];
    ++runs_;
    if (kind_ == "crash") std::abort();
    if (kind_ == "hang") std::this_thread::sleep_for(std::chrono::hours(1));
    if (kind_ == "flood") flood(seq);
    if (kind_ == "garbage") return send("this is no JSON");
    if (kind_ == "half-line") {
      std::fputs(R"({"seq":)", stdout);
      std::fflush(stdout);
      std::_Exit(0);
    }
    if (kind_ == "wrong-seq") return send(reference_reply(profile_, program, seq + 1));
    if (kind_ == "empty" || (kind_ == "leak" && runs_ > 1)) {
      return send(fmt::format(R"({{"seq":{},"outcome":"ok","records":[]}})", seq));
    }
    if (kind_ == "always-alarm") {
      return send(fmt::format(R"({{"seq":{},"outcome":"alarm","records":[],)"
                              R"("alarm":{{"native":"1","class":"no-tool","b":1}}}})",
                              seq));
    }
    if (kind_ == "late") std::this_thread::sleep_for(std::chrono::seconds(3));
    send(reference_reply(profile_, program, seq));
  }

  void configure(const nlohmann::json& message) {
    nlohmann::json keys = message["profile"];
    keys["dialect"] = message["dialect"];
    auto profile = reference::profile_from_json(keys.dump());
    if (auto* error = std::get_if<reference::ProfileError>(&profile)) {
      return send(nlohmann::json{{"ok", false}, {"message", error->message}}.dump());
    }
    profile_ = std::get<reference::Profile>(std::move(profile));
    send(R"({"ok":true})");
  }

 private:
  std::string kind_;
  reference::Profile profile_;
  int runs_ = 0;
};

int misbehave(const std::string& kind) {
  Misbehaviour subject(kind);
  std::string line;
  while (std::getline(std::cin, line)) {
    const nlohmann::json message = nlohmann::json::parse(line);
    const std::string command = message["cmd"];
    if (command == "start") send(start_reply());
    if (command == "configure") subject.configure(message);
    if (command == "reset") send(R"({"ok":true})");
    if (command == "run") subject.run(message);
    if (command == "stop" && kind == "abort-at-stop") std::abort();
    if (command == "stop") break;
  }
  return kGo;
}

}  // namespace

void add_misbehave(Command& program) {
  auto kind = std::make_shared<std::string>();
  Command command = program.add_hidden_command("misbehave", "A subject of the self-test");
  command.needed("kind", *kind, "what is wrong with it");
  command.run([kind] { return misbehave(*kind); });
}

}  // namespace gonogo::cli
