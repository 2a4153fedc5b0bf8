// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kill matrix in words: rows, the whole as Markdown, and what is wrong with it.
#include <fmt/format.h>

#include <algorithm>

#include "hunt/kill_matrix.hpp"

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

std::string cells(const MatrixRow& row, Method method) {
  const Kill& kill = row.kills.at(method);
  if (!kill.killed) return method == Method::corpus ? " - | - |" : " - | - | - |";
  if (method == Method::corpus) return fmt::format(" {} | {:.2f} |", kill.executions, kill.seconds);
  return fmt::format(" {} | {:.2f} | {} |", kill.executions, kill.seconds, kill.blocks);
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
  std::string text =
      fmt::format("{} of {} faults, median {} programs and {:.2f} s, at most {} and {:.2f} s",
                  summary.killed, summary.faults, summary.median_executions, summary.median_seconds,
                  summary.most_executions, summary.most_seconds);
  if (method != Method::corpus) {
    text += fmt::format("; reduced to a median of {} blocks, at most {}", summary.median_blocks,
                        summary.most_blocks);
  }
  return text;
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
      "- operations: lists of machining operations of `gonogo hunt --method operations`, written for "
      "every dialect, until\n  the paths differ or one is unsafe\n"
      "- hunt: programs of `gonogo hunt` until the first finding, and its blocks when reduced\n"
      "- fuzz: the same with generated programs only, without coverage and mutation\n\n";
  for (const Method method : methods) {
    text += fmt::format("{}: {}.  \n", name(method), summary_text(rows, method));
  }
  text += "\n| fault | clause |";
  std::string rule = "|---|---|";
  for (const Method method : methods) {
    text += fmt::format(" {} | s |", name(method));
    rule += "--:|--:|";
    if (method == Method::corpus) continue;
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
