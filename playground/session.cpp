// SPDX-License-Identifier: GPL-3.0-or-later
#include "playground/session.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <variant>

#include "oracle/steps/different_assignments.hpp"
#include "publish/manual/motion_text.hpp"
#include "publish/report/page_paths.hpp"
#include "reference/dialect.hpp"
#include "reference/outcome_text.hpp"

namespace gonogo::playground {
namespace {

using oracle::report::Json;

constexpr int kGo = 0;
constexpr int kNoGo = 1;
constexpr int kWrongUse = 2;
constexpr int kUndecided = 3;
constexpr std::size_t kStepsOfTurn = 64;

struct Request {
  std::string file = "program.nc";
  reference::Profile profile;
  std::string program;
  bool draw = false;
  std::size_t most = 0;  // records; 0: any number
};

class WrongUse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

reference::Profile profile_of(const Json& head) {
  const std::string dialect = head.value("dialect", "");
  const std::string text = head.value("profile", "");
  const bool json = text.find_first_not_of(" \t\r\n") != std::string::npos &&
                    text[text.find_first_not_of(" \t\r\n")] == '{';
  auto result = json ? reference::profile_from_json(text, dialect)
                     : reference::profile_from_toml(text, dialect);
  if (auto* error = std::get_if<reference::ProfileError>(&result)) {
    throw WrongUse("profile: " + error->message);
  }
  auto profile = std::get<reference::Profile>(std::move(result));
  if (profile.dialect != dialect) {
    throw WrongUse(
        fmt::format("The profile is one of dialect {}, not of {}.", profile.dialect, dialect));
  }
  for (const Json& choice : head.value("readings", Json::array())) {
    const auto written = choice.get<std::string>();
    const std::size_t equals = written.find('=');
    if (equals == std::string::npos) {
      throw WrongUse(fmt::format("The reading {} is not of the form key=value.", written));
    }
    const auto error =
        reference::set_reading(profile, written.substr(0, equals), written.substr(equals + 1));
    if (error) throw WrongUse(error->message);
  }
  return profile;
}

Request read_request(std::string_view text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const Json head = Json::parse(text.substr(0, end));
  Request request;
  request.file = head.value("file", request.file);
  request.draw = head.value("draw", false);
  request.most = head.value("most", std::size_t{0});
  request.profile = profile_of(head);
  request.program = text.substr(std::min(end + 1, text.size()));
  if (request.program.empty()) {
    throw WrongUse(request.file + " is empty. Write an NC program.");
  }
  return request;
}

// The motions of a program as the page draws and steps through them.
class Drawing {
 public:
  explicit Drawing(const reference::Profile& profile)
      : sampler_(profile.initial.at), texts_(profile.initial.at) {}

  void operator()(const reference::Record& record) {
    if (cut_) return;
    cut_ = !sampler_.add(record);
    if (!cut_) add(record.block, texts_.next(record), record.clause);
  }
  void operator()(const reference::Renaming& renaming) {
    sampler_.rename(renaming.shift);
    texts_.rename(renaming.shift);
  }
  void operator()(const reference::AlarmReport& report) {
    const reference::Alarm& first = report.alarms.front();
    end("alarm", report.block, fmt::format("alarm {}", reference::name(first.alarm)), first.clause);
  }
  void operator()(const reference::NotCovered& outside) {
    end("not-covered", outside.block, "not covered: " + outside.code, reference::kNoClause);
  }
  template <typename Open>
  void operator()(const Open&) {}  // comes only where paths are left open

  void finish(Json& head) {
    head["steps"] = std::move(steps_);
    head["moves"] = oracle::report::moves_json(sampler_.take(), kStepsOfTurn);
    head["cut"] = cut_;
  }

 private:
  void end(std::string_view kind, std::uint64_t block, const std::string& text,
           reference::ClauseId clause) {
    if (cut_) return;
    sampler_.add_end(kind, block, reference::clause_name(clause), text);
    add(block, text, clause);
  }
  void add(std::uint64_t block, const std::string& text, reference::ClauseId clause) {
    steps_.push_back({{"b", block}, {"text", text}, {"clause", reference::clause_name(clause)}});
  }

  oracle::report::PathSampler sampler_;
  oracle::manual::MotionTexts texts_;
  Json steps_ = Json::array();
  bool cut_ = false;
};

// `gonogo expand` on a program in memory.
class Run {
 public:
  explicit Run(const Request& request)
      : request_(request),
        profile_(oracle::profile_to_show(request.profile, request.program)),
        bytes_(request.program),
        lines_(bytes_),
        expander_(profile_, lines_, reference::OpenPaths::shown),
        drawing_(request.profile) {
    expander_.on_warning([this](const reference::Warning& warning, const grammar::Line& line) {
      reference::append_diagnostic(warning, request_.file, line, messages_);
    });
  }

  std::string answer() {
    std::size_t count = 0;
    bool stopped = false;
    while (const reference::Item* item = expander_.next()) {
      stopped = request_.most != 0 && ++count > request_.most;
      if (stopped) break;
      std::visit([this](const auto& one) { take(one); }, *item);
      if (request_.draw) std::visit(drawing_, *item);
    }
    Json head = {{"exit", exit_}, {"messages", messages_}, {"readings", readings()}};
    head["stopped"] = stopped;
    if (request_.draw) {
      head["lathe"] = reference::find_dialect(request_.profile.dialect)->lathe;
      drawing_.finish(head);
      head["limits"] = stopped ? Json::array() : limits();
    }
    return head.dump() + '\n' + records_;
  }

 private:
  void take(const reference::Record& record) {
    append_json(record, records_);
    records_ += '\n';
  }
  void take(const reference::AlarmReport& report) {
    append_json(report, records_);
    records_ += '\n';
    append_diagnostic(report, request_.file, expander_.failed_line(), messages_);
    if (report.syntax) append_further_errors();
    exit_ = kNoGo;
  }
  void take(const reference::NotCovered& outside) {
    append_json(outside, records_);
    records_ += '\n';
    append_diagnostic(outside, request_.file, expander_.failed_line(), messages_);
    append_further_errors();
    exit_ = kUndecided;
  }
  template <typename Open>
  void take(const Open&) {}

  void append_further_errors() {
    const reference::Dialect* dialect = reference::find_dialect(request_.profile.dialect);
    reference::append_further_syntax_errors(dialect->grammar, lines_, request_.file, messages_);
  }

  Json readings() const {
    Json list = Json::array();
    for (const reference::ReadingKey key : expander_.readings().touched()) {
      list.push_back(
          {{"name", reference::reading(key).name}, {"value", request_.profile.readings.get(key)}});
    }
    return list;
  }

  // What the manual fixes where it leaves the path open.
  Json limits() const {
    grammar::MemorySource bytes(request_.program);
    grammar::LineSource lines(bytes);
    reference::Expander judged(profile_, lines, reference::OpenPaths::judged);
    std::vector<oracle::report::Limit> all;
    while (const reference::Item* item = judged.next()) {
      for (auto& limit : oracle::report::limits_of(*item)) all.push_back(std::move(limit));
    }
    return oracle::report::limits_json(all);
  }

  const Request& request_;
  const reference::Profile profile_;
  grammar::MemorySource bytes_;
  grammar::LineSource lines_;
  reference::Expander expander_;
  Drawing drawing_;
  std::string records_;
  std::string messages_;
  int exit_ = kGo;
};

std::string refusal(const std::string& reason) {
  return Json{{"exit", kWrongUse}, {"messages", reason + "\n"}, {"readings", Json::array()}}
             .dump() +
         '\n';
}

Json clauses_of(const reference::Dialect& dialect) {
  Json list = Json::array();
  for (const reference::Clause& clause : dialect.clauses) {
    list.push_back({{"id", clause.id},
                    {"text", clause.text},
                    {"source", clause.source},
                    {"level", reference::name(clause.level)},
                    {"basis", reference::name(clause.basis())}});
  }
  return list;
}

Json readings_of(const reference::Dialect& dialect) {
  Json list = Json::array();
  for (const reference::Reading& reading : reference::readings()) {
    if (!reading.belongs_to(dialect.name)) continue;
    list.push_back({{"name", reading.name},
                    {"text", reading.text},
                    {"clause", reference::clause_name(reading.clause)},
                    {"alternatives", std::vector<std::string_view>(reading.alternatives.begin(),
                                                                   reading.alternatives.end())},
                    {"default", reading.fallback},
                    {"length", reading.is_length}});
  }
  return list;
}

}  // namespace

std::string answer(std::string_view text) {
  try {
    const Request request = read_request(text);
    return Run(request).answer();
  } catch (const WrongUse& error) {
    return refusal(error.what());
  } catch (const Json::exception& error) {
    return refusal(std::string("The request cannot be read: ") + error.what());
  } catch (const exact::Undecided& error) {
    return refusal(error.what());
  }
}

std::string catalog() {
  Json list = Json::array();
  for (const reference::Dialect& dialect : reference::dialects()) {
    list.push_back({{"name", dialect.name},
                    {"clauses", clauses_of(dialect)},
                    {"readings", readings_of(dialect)}});
  }
  return list.dump();
}

}  // namespace gonogo::playground
