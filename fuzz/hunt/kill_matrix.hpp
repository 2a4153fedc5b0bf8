// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kill matrix: what it costs each method to find each planted fault. A bench that cannot fail
// says nothing, so it also says what is wrong with itself.
#pragma once

#include <map>

#include "fuzz/hunt/hunt.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::hunt {

enum class Method {
  corpus,      // the vectors, in their order
  properties,  // the subject's answers to related programs, without the reference
  operations,  // lists of operations in every dialect, without the reference
  hunt,        // led by the reference's coverage
  fuzz,        // generated programs only
};
inline constexpr Method kMethods[] = {Method::corpus, Method::properties, Method::operations,
                                      Method::hunt, Method::fuzz};
std::string_view name(Method method);
std::optional<Method> method_named(std::string_view name);

// An expander with a planted fault, or without one.
struct MatrixTarget {
  std::string name;    // "gsk+taper-sign"; "gsk"
  std::string clause;  // that the fault breaks; empty: there is no fault
  std::vector<std::string> dialects;
  SubjectMaker make;
  SubjectMaker control;  // the same without the fault: what it shows too is not of the fault
  std::vector<SubjectMaker> peers = {};  // sound ones of other dialects, for Method::operations
  // How often the line of the fault ran in this process; null: not known.
  std::function<std::uint64_t()> reached_count = {};
  std::string what = {};    // the fault does wrong
  std::string report = {};  // address of a public report of a real one; empty: none
};

// The result of one method with one target.
struct Kill {
  bool killed = false;
  std::size_t executions = 0;  // programs or cases until then, or in all
  double seconds = 0;          // of processor time, the same, without what `reached` and on took
  std::size_t blocks = 0;      // of the reduced finding; corpus: 0
  std::string how;             // signature, or id of the case
  // Programs or cases until the line of the fault first ran, and until an answer first differed
  // from that of the expander without it; 0: never. An expander without a fault always has 0.
  std::size_t reached = 0;
  std::size_t triggered = 0;
};

struct MatrixRow {
  std::string target;
  std::string clause;
  std::map<Method, Kill> kills;
  std::string what = {};
  std::string report = {};
};

struct MatrixOptions {
  std::vector<Method> methods;
  const oracle::Corpus* corpus = nullptr;  // needed by Method::corpus
  std::uint64_t seed = 1;
  double most_seconds = 60;             // of processor time for a fault
  std::size_t clean_programs = 20'000;  // of each dialect, for an expander without a fault
  bool blind = false;                   // a judge that says GO to everything: the bench must notice
};

MatrixRow matrix_row(const MatrixTarget& target, const MatrixOptions& options);

// What is wrong, sentences: faults that a method does not find, or says to find before any answer
// differed, fault-free expanders that one finds, a method that finds nothing at all.
std::vector<std::string> complaints(const std::vector<MatrixRow>& rows,
                                    const std::vector<Method>& methods);

// A method's figures over all faults that it finds.
struct MatrixSummary {
  std::size_t faults = 0;
  std::size_t reached = 0;
  std::size_t triggered = 0;
  std::size_t killed = 0;
  double median_seconds = 0;
  double most_seconds = 0;
  std::size_t median_executions = 0;
  std::size_t most_executions = 0;
  std::size_t median_blocks = 0;
  std::size_t most_blocks = 0;
};
MatrixSummary summary_of(const std::vector<MatrixRow>& rows, Method method);

// One row for a terminal; the whole for docs/kill-matrix.md.
std::string row_text(const MatrixRow& row);
std::string matrix_markdown(const std::vector<MatrixRow>& rows, const std::vector<Method>& methods);
// The rows that have a public report: how long until each method first finds them. Empty: none has.
std::string field_defects_markdown(const std::vector<MatrixRow>& rows,
                                   const std::vector<Method>& methods);
std::string summary_text(const std::vector<MatrixRow>& rows, Method method);

}  // namespace gonogo::hunt
