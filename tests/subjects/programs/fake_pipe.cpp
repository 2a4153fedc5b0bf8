// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject of the pipe protocol that misbehaves as its argument says.
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

const std::string kRecord = R"({"k":"feed","b":1,"to":{"x":"1.5"},"f":"200"})";

std::string mode;
std::string configuration;  // the line that said it
int runs = 0;

void say(const std::string& line) {
  std::cout << line << '\n' << std::flush;
}

[[noreturn]] void sleep_for_ever() {
  while (true) pause();
}

std::string seq_of(const std::string& line) {
  const std::size_t at = line.find("\"seq\":") + 6;
  return line.substr(at, line.find(',', at) - at);
}

void answer(const std::string& seq, const std::string& rest) {
  say("{\"seq\":" + seq + rest + "}");
}

void answer_well(const std::string& seq) {
  answer(seq, ",\"outcome\":\"ok\",\"records\":[" + kRecord + "]");
}

void flood(const std::string& seq, const std::string& record) {
  while (true) answer(seq, ",\"records\":[" + record + "],\"more\":true");
}

void eat_memory() {
  constexpr std::size_t kPiece = std::size_t{8} << 20;
  std::vector<char*> pieces;
  while (pieces.size() < 200) {
    pieces.push_back(static_cast<char*>(std::malloc(kPiece)));
    std::memset(pieces.back(), 1, kPiece);
    usleep(2000);
  }
  sleep_for_ever();
}

void long_line(const std::string& seq, std::size_t bytes) {
  std::cout << "{\"seq\":" << seq << ",\"message\":\"";
  const std::string piece(1 << 20, 'a');
  for (std::size_t written = 0; written < bytes; written += piece.size()) std::cout << piece;
  std::cout << "\",\"outcome\":\"error\"}\n" << std::flush;
}

void skip(const std::string& seq, const std::string& records) {
  answer(seq, ",\"outcome\":\"skip\",\"feature\":\"g116\",\"records\":[" + records + "]");
}

void many_parts(const std::string& seq) {
  for (int i = 0; i < 100; ++i) answer(seq, ",\"records\":[" + kRecord + "],\"more\":true");
  answer(seq, ",\"outcome\":\"ok\",\"records\":[" + kRecord + "]");
}

// A child in the group that keeps the pipes open when its parent has gone.
void leave_grandchild() {
  if (fork() == 0) sleep_for_ever();
}

void noise(const std::string& seq) {
  std::cerr << "tool \xB5\xB6 is worn\n" << std::flush;
  answer_well(seq);
}

// What the first run left behind shows in the second.
void leak(const std::string& seq) {
  answer(seq, ",\"outcome\":\"ok\",\"records\":[{\"k\":\"dwell\",\"s\":\"" + std::to_string(runs) +
                  "\"}]");
}

// Puts back what it was told, so that a test can see it.
void echo(const std::string& seq, const std::string& line) {
  std::string quoted;
  for (char c : line) quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  answer(seq, ",\"outcome\":\"error\",\"message\":\"" + quoted + "\"");
}

// Answers when so many programs have come: only a runner that sends ahead gets there.
void answer_by_four(const std::string& seq, bool in_order) {
  static std::vector<std::string> waiting;
  waiting.push_back(seq);
  if (waiting.size() < 4) return;
  if (!in_order) std::swap(waiting[0], waiting[1]);
  for (const std::string& each : waiting) answer_well(each);
  waiting.clear();
}

bool wants(const std::string& line, const char* what) {
  return line.find(what) != std::string::npos;
}

bool has_more_to_do() {
  return std::cin.rdbuf()->in_avail() > 0;
}

// Many answers a write: those not yet written are lost with the process.
void answer_in_batches(const std::string& seq, const std::string& line) {
  if (wants(line, "ABORT")) std::abort();
  std::cout << "{\"seq\":" << seq << ",\"outcome\":\"ok\",\"records\":[]}\n";
  if (!has_more_to_do()) std::cout << std::flush;
}

// As much as a pipe does not hold, for each program.
void answer_at_length(const std::string& seq) {
  answer(seq, ",\"outcome\":\"error\",\"message\":\"" + std::string(1 << 20, 'a') + "\"");
}

using Action = std::function<void(const std::string& seq, const std::string& line)>;

// NOLINTNEXTLINE(readability-function-size): a table.
const std::map<std::string, Action>& actions() {
  static const std::map<std::string, Action> kActions = {
      {"alarm",
       [](auto& seq, auto&) {
         answer(seq, ",\"outcome\":\"alarm\",\"records\":[" + kRecord +
                         "],\"alarm\":{\"native\":\"PS0061\",\"class\":\"value-sign\",\"b\":3,"
                         "\"word\":\"Q\"}");
       }},
      {"skip",
       [](auto& seq, auto&) {
         answer(seq, ",\"outcome\":\"skip\",\"feature\":\"g116\",\"message\":\"not yet\"");
       }},
      {"skip-beside-records", [](auto& seq, auto&) { skip(seq, kRecord + "," + kRecord); }},
      {"skip-behind-parts",
       [](auto& seq, auto&) {
         for (int i = 0; i < 100; ++i) answer(seq, ",\"records\":[" + kRecord + "],\"more\":true");
         skip(seq, "");
       }},
      {"error",
       [](auto& seq, auto&) { answer(seq, ",\"outcome\":\"error\",\"message\":\"sorry\""); }},
      {"abort", [](auto&, auto&) { std::abort(); }},
      {"exit7", [](auto&, auto&) { std::_Exit(7); }},
      {"exit0", [](auto&, auto&) { std::_Exit(0); }},
      {"second-aborts", [](auto& seq, auto&) { runs == 2 ? std::abort() : answer_well(seq); }},
      {"hang", [](auto&, auto&) { sleep_for_ever(); }},
      {"hang-deaf",
       [](auto&, auto&) {
         signal(SIGTERM, SIG_IGN);
         signal(SIGINT, SIG_IGN);
         sleep_for_ever();
       }},
      {"die-with-grandchild",
       [](auto&, auto&) {
         leave_grandchild();
         std::_Exit(9);
       }},
      {"hang-with-grandchild",
       [](auto&, auto&) {
         leave_grandchild();
         sleep_for_ever();
       }},
      {"flood", [](auto& seq, auto&) { flood(seq, kRecord); }},
      {"flood-empty", [](auto& seq, auto&) { flood(seq, ""); }},
      {"garbage", [](auto&, auto&) { say("%PDF \xFF\xFE"); }},
      {"half-stall",
       [](auto& seq, auto&) {
         std::cout << "{\"seq\":" << seq << ",\"outc" << std::flush;
         sleep_for_ever();
       }},
      {"half-exit",
       [](auto& seq, auto&) {
         std::cout << "{\"seq\":" << seq << ",\"outc" << std::flush;
         std::_Exit(0);
       }},
      {"late-first",
       [](auto& seq, auto&) {
         if (runs == 1 && access(std::getenv("FAKE_MARK"), F_OK) != 0) {
           std::fclose(std::fopen(std::getenv("FAKE_MARK"), "w"));
           usleep(600'000);
         }
         leak(seq);
       }},
      {"slow-parts",
       [](auto& seq, auto&) {
         for (int i = 0; i < 10; ++i) {
           answer(seq, ",\"records\":[],\"more\":true");
           usleep(100'000);
         }
         answer_well(seq);
       }},
      {"wrong-seq", [](auto&, auto&) { answer_well("99"); }},
      {"two-replies",
       [](auto& seq, auto&) {
         std::cout << "{\"seq\":" << seq << ",\"outcome\":\"ok\"}\n{\"seq\":" << seq
                   << ",\"outcome\":\"ok\"}\n"
                   << std::flush;
       }},
      {"duplicate-key",
       [](auto& seq, auto&) {
         answer(seq, ",\"outcome\":\"ok\",\"records\":[{\"k\":\"dwell\",\"s\":\"1\",\"s\":\"2\"}]");
       }},
      {"bare-number",
       [](auto& seq, auto&) {
         answer(seq, ",\"outcome\":\"ok\",\"records\":[{\"k\":\"dwell\",\"s\":1.5}]");
       }},
      {"long-line", [](auto& seq, auto&) { long_line(seq, std::size_t{100} << 20); }},
      {"noise", [](auto& seq, auto&) { noise(seq); }},
      {"parts", [](auto& seq, auto&) { many_parts(seq); }},
      {"echo", [](auto& seq, auto& line) { echo(seq, line); }},
      {"eat-memory", [](auto&, auto&) { eat_memory(); }},
      {"told", [](auto& seq, auto&) { echo(seq, configuration); }},
      {"told-one", [](auto& seq, auto&) { echo(seq, configuration); }},
      {"leak", [](auto& seq, auto&) { leak(seq); }},
      {"by-four", [](auto& seq, auto&) { answer_by_four(seq, true); }},
      {"by-four-swapped", [](auto& seq, auto&) { answer_by_four(seq, false); }},
      {"third-aborts", [](auto& seq, auto&) { runs == 3 ? std::abort() : leak(seq); }},
      {"aborts-on-demand",
       [](auto& seq, auto& line) { wants(line, "ABORT") ? std::abort() : leak(seq); }},
      {"hangs-on-demand",
       [](auto& seq, auto& line) { wants(line, "HANG") ? sleep_for_ever() : leak(seq); }},
      {"batches", answer_in_batches},
      {"aborts-with-more-to-do",
       [](auto& seq, auto&) { has_more_to_do() ? std::abort() : answer_well(seq); }},
      {"slow", [](auto& seq, auto&) { usleep(120'000), leak(seq); }},
      {"long-replies", [](auto& seq, auto&) { answer_at_length(seq); }},
      {"pid",
       [](auto& seq, auto&) {
         answer(seq, ",\"outcome\":\"error\",\"message\":\"" + std::to_string(getpid()) + "\"");
       }},
  };
  return kActions;
}

// FAKE_WINDOW: how many programs may be sent ahead.
std::string window() {
  const char* given = std::getenv("FAKE_WINDOW");
  return given == nullptr ? std::string() : std::string(",\"max_in_flight\":") + given;
}

std::string readings() {
  return mode == "told-one" ? R"(,"readings":["gsk.g94.rewrite"])" : "";
}

void start() {
  if (mode == "never-starts") sleep_for_ever();
  if (mode == "dies-at-start") {
    std::cerr << "licence expired\n";
    std::_Exit(5);
  }
  if (mode == "protocol2") return say(R"({"protocol":2,"subject":{"name":"fake"}})");
  if (mode == "start-garbage") return say("hello");
  const std::string features = mode == "echo" ? R"(["blocks","bytes"])" : R"(["blocks"])";
  say(R"({"protocol":1,"subject":{"name":"fake","version":"1.0"},"dialects":{"gsk988ta":["g94"]},)"
      R"("features":)" +
      features + R"(,"numeric":{"kind":"fixed","resolution":"0.001"})" + readings() + window() +
      "}");
}

void configure() {
  if (mode == "refuses") return say(R"({"ok":false,"message":"no readings here"})");
  if (mode == "dies-in-configure") std::abort();
  if (mode == "hangs-in-configure") sleep_for_ever();
  say(R"({"ok":true})");
}

}  // namespace

int main(int count, char** arguments) {
  std::ios::sync_with_stdio(false);  // so that std::cin says what it has read ahead
  mode = count > 1 ? arguments[1] : "good";
  if (mode == "talks-first") say("ready.");
  for (std::string line; std::getline(std::cin, line);) {
    if (line.find("\"cmd\":\"start\"") != std::string::npos) {
      start();
    } else if (line.find("\"cmd\":\"configure\"") != std::string::npos) {
      configuration = line;
      configure();
    } else if (line.find("\"cmd\":\"run\"") != std::string::npos) {
      ++runs;
      const auto action = actions().find(mode);
      if (action == actions().end()) {
        answer_well(seq_of(line));
      } else {
        action->second(seq_of(line), line);
      }
      if (mode == "exits-between") return 0;
    } else {
      if (mode == "aborts-at-stop") std::abort();
      return 0;
    }
  }
}
