// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kill matrix in words: rows, the whole as Markdown, and what is wrong with it.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/hunt/kill_matrix.hpp"

namespace gonogo::hunt {
namespace {

template <typename Value>
Value median(std::vector<Value> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  return values[values.size() / 2];
}

template <typename Value>
Value most(const std::vector<Value>& values) {
  return values.empty() ? Value{} : std::ranges::max(values);
}

// "17"; "-": never.
std::string count_or_dash(std::size_t count) {
  return count == 0 ? "-" : fmt::format("{}", count);
}

bool tells_blocks(Method method) {
  return method != Method::corpus;
}

std::string cells(const MatrixRow& row, Method method) {
  const Kill& kill = row.kills.at(method);
  std::string text =
      fmt::format(" {} | {} |", count_or_dash(kill.reached), count_or_dash(kill.triggered));
  text += kill.killed ? fmt::format(" {} | {:.2f} |", kill.executions, kill.seconds) : " - | - |";
  if (tells_blocks(method)) {
    text += kill.killed ? fmt::format(" {} |", kill.blocks) : std::string(" - |");
  }
  return text;
}

// "FreeCAD/FreeCAD#25023" as a link to where that is.
std::string report_link(const std::string& address) {
  constexpr std::string_view kHost = "https://github.com/";
  std::string name = address.starts_with(kHost) ? address.substr(kHost.size()) : address;
  for (const std::string_view part : {"/issues/", "/pull/"}) {
    const std::size_t place = name.find(part);
    if (place != std::string::npos) name.replace(place, part.size(), "#");
  }
  return fmt::format("[{}]({})", name, address);
}

}  // namespace

std::vector<std::string> complaints(const std::vector<MatrixRow>& rows,
                                    const std::vector<Method>& methods) {
  std::vector<std::string> sentences;
  for (const Method method : methods) {
    std::size_t killed = 0;
    std::size_t faults = 0;
    for (const MatrixRow& row : rows) {
      const Kill& kill = row.kills.at(method);
      const bool has_fault = !row.clause.empty();
      faults += has_fault ? 1 : 0;
      killed += has_fault && kill.killed ? 1 : 0;
      // Without the reference not everything shows: not what is wrong everywhere in the same way,
      // nor what no list of operations asks for.
      const bool asks_reference = method != Method::properties && method != Method::operations;
      if (has_fault && !kill.killed && asks_reference) {
        sentences.push_back(fmt::format("{} does not find {}.", name(method), row.target));
      } else if (has_fault && kill.killed && kill.triggered == 0) {
        sentences.push_back(
            fmt::format("{} finds {}, and no answer differed from those without the fault: {}.",
                        name(method), row.target, kill.how));
      } else if (!has_fault && kill.killed) {
        sentences.push_back(fmt::format("{} is NO-GO by {}, and has no fault: {}.", row.target,
                                        name(method), kill.how));
      }
    }
    if (killed == 0) {
      sentences.push_back(fmt::format("{} finds none of {} planted faults: the bench is broken.",
                                      name(method), faults));
    }
  }
  return sentences;
}

MatrixSummary summary_of(const std::vector<MatrixRow>& rows, Method method) {
  MatrixSummary summary;
  std::vector<double> seconds;
  std::vector<std::size_t> executions;
  std::vector<std::size_t> blocks;
  for (const MatrixRow& row : rows) {
    if (row.clause.empty()) continue;
    ++summary.faults;
    const Kill& kill = row.kills.at(method);
    summary.reached += kill.reached != 0 ? 1 : 0;
    summary.triggered += kill.triggered != 0 ? 1 : 0;
    if (!kill.killed) continue;
    ++summary.killed;
    seconds.push_back(kill.seconds);
    executions.push_back(kill.executions);
    blocks.push_back(kill.blocks);
  }
  summary.median_seconds = median(seconds);
  summary.most_seconds = most(seconds);
  summary.median_executions = median(executions);
  summary.most_executions = most(executions);
  summary.median_blocks = median(blocks);
  summary.most_blocks = most(blocks);
  return summary;
}

std::string row_text(const MatrixRow& row) {
  std::string text = fmt::format("{:<44}", row.target);
  for (const auto& [method, kill] : row.kills) {
    text += fmt::format(" {} ", name(method));
    if (!row.clause.empty()) {
      text += fmt::format("reached {}, triggered {}, killed ", count_or_dash(kill.reached),
                          count_or_dash(kill.triggered));
    }
    if (!kill.killed) {
      text += fmt::format("{} {} in {:.2f} s;", row.clause.empty() ? "GO" : "SURVIVES",
                          kill.executions, kill.seconds);
    } else {
      text += fmt::format("{} in {:.2f} s", kill.executions, kill.seconds);
      text += method == Method::corpus ? fmt::format(" ({});", kill.how)
                                       : fmt::format(", {} blocks ({});", kill.blocks, kill.how);
    }
  }
  return text + "\n";
}

std::string summary_text(const std::vector<MatrixRow>& rows, Method method) {
  const MatrixSummary summary = summary_of(rows, method);
  std::string text = fmt::format(
      "{} of {} faults reached, {} triggered, {} killed; median {} programs and {:.2f} s, "
      "at most {} and {:.2f} s",
      summary.reached, summary.faults, summary.triggered, summary.killed, summary.median_executions,
      summary.median_seconds, summary.most_executions, summary.most_seconds);
  if (tells_blocks(method)) {
    text += fmt::format("; reduced to a median of {} blocks, at most {}", summary.median_blocks,
                        summary.most_blocks);
  }
  return text;
}

std::string field_defects_markdown(const std::vector<MatrixRow>& rows,
                                   const std::vector<Method>& methods) {
  std::string lines;
  std::size_t reports = 0;
  for (const MatrixRow& row : rows) {
    if (row.report.empty()) continue;
    ++reports;
    lines += fmt::format("| {} | {} | {} |", row.target, row.what, report_link(row.report));
    for (const Method method : methods) {
      const Kill& kill = row.kills.at(method);
      lines += kill.killed ? fmt::format(" {} | {:.3f} |", kill.executions, kill.seconds)
                           : std::string(" - | - |");
    }
    lines += "\n";
  }
  if (reports == 0) return {};
  std::string head = "| fault | what | report |";
  std::string rule = "|---|---|---|";
  for (const Method method : methods) {
    head += fmt::format(" {} | s |", name(method));
    rule += "--:|--:|";
  }
  return fmt::format(
      "\n## Field defects\n\nThe {} planted faults that were reported of real programs: programs, "
      "cases "
      "or lists until a method first finds them,\nand seconds of processor time.\n\n{}\n{}\n{}",
      reports, head, rule, lines);
}

std::string matrix_markdown(const std::vector<MatrixRow>& rows,
                            const std::vector<Method>& methods) {
  std::string text =
      "# The kill matrix\n\nWhat it costs to find each planted fault of the built-in expanders. "
      "Written by\n`gonogo faults --matrix --format markdown`; seconds are of processor time on "
      "one core.\n\n"
      "- corpus: cases of the checked-in corpus until the first that is NO-GO\n"
      "- properties: programs of `gonogo hunt --method properties`, each with those related to it, "
      "until "
      "two answers\n  contradict each other; a fault that is wrong in the same way everywhere "
      "contradicts nothing\n"
      "- operations: lists of machining operations of `gonogo hunt --method operations`, written "
      "for "
      "every dialect, until\n  the paths differ or one is unsafe\n"
      "- hunt: programs of `gonogo hunt` until the first finding, and its blocks when reduced\n"
      "- fuzz: the same with generated programs only, without coverage and mutation\n\n"
      "Programs of each method until a fault is\n\n"
      "- reached: its line ran\n"
      "- triggered: an answer differs from that of the same expander without the fault\n"
      "- killed: the method said so, and s the seconds until then, without those of counting\n\n"
      "A fault that is reached but not triggered needs other programs; one that is triggered but\n"
      "not killed needs another judge: or the difference is one that no text forbids, or that the\n"
      "method cannot see.\n\n";
  for (const Method method : methods) {
    text += fmt::format("{}: {}.  \n", name(method), summary_text(rows, method));
  }
  text += "\n| fault | clause |";
  std::string rule = "|---|---|";
  for (const Method method : methods) {
    text += fmt::format(" {}: reached | triggered | killed | s |", name(method));
    rule += "--:|--:|--:|--:|";
    if (!tells_blocks(method)) continue;
    text += " blocks |";
    rule += "--:|";
  }
  text += "\n" + rule + "\n";
  for (const MatrixRow& row : rows) {
    if (row.clause.empty()) continue;
    text += fmt::format("| {} | {} |", row.target, row.clause);
    for (const Method method : methods) text += cells(row, method);
    text += "\n";
  }
  text += field_defects_markdown(rows, methods);
  text += "\nWithout a fault:\n\n";
  for (const MatrixRow& row : rows) {
    if (!row.clause.empty()) continue;
    text += fmt::format("- {}:", row.target);
    for (const Method method : methods) {
      const Kill& kill = row.kills.at(method);
      text += fmt::format(" {} {} {},", kill.executions,
                          method == Method::corpus ? "cases" : "programs",
                          kill.killed ? "NO-GO: " + kill.how : std::string("GO"));
    }
    text.back() = '\n';
  }
  return text;
}

}  // namespace gonogo::hunt
