// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties: noise within the tolerance is GO; one sample moved out of the tube is NO-GO, and is
// the witness.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/capture/sampling.hpp"

namespace gonogo::oracle {
namespace {

// From (10, 0) a quarter about (0, 0) to (0, -10), then on to (-20, -10) and up to z 5.
const SampledCase kPath{"G17 G00 X20 Y0\nG02 X0 Y-10 I-10 J0 F1200\nG01 X-40\nZ5\n"};

std::vector<SampledMachine::Row> sampled_path() {
  SampledMachine machine(0.02);
  machine.line({10, 0, 0}, 6000).turn({0, 0, 0}, -90, 1200);
  machine.line({-20, -10, 0}, 1200).line({-20, -10, 5}, 1200);
  return machine.rows();
}

// Ten-thousandths of a millimetre, below the tolerance of 0.001.
double noise() {
  return *rc::gen::inRange(-9, 10) * 1e-4;
}

std::vector<SampledMachine::Row> noisy_path() {
  auto rows = sampled_path();
  for (auto& row : rows) {
    row.at.x += noise();
    row.at.y += noise();
    row.at.z += noise();
  }
  return rows;
}

RC_GTEST_PROP(SampledNoise, NoiseWithinTheToleranceIsGo, ()) {
  const Verdict verdict = judge_samples(kPath, csv_of(noisy_path()));
  RC_LOG() << name(verdict.kind) << " " << verdict.message << " " << verdict.got;
  RC_ASSERT(verdict.kind == VerdictKind::pass_tolerance);
}

// Samples of the last three motions, clear of their ends: moved along an axis that does not move
// there (z in the plane, x on the way up).
RC_GTEST_PROP(SampledNoise, OneSampleOutOfTheTubeIsTheWitness, ()) {
  auto rows = noisy_path();
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Point& at = rows[i].at;
    const bool on_arc = at.x > 0.5 && at.x < 9.5 && at.y < -0.5;
    const bool on_line = at.x < -0.5 && at.x > -19.5;
    if (on_arc || on_line) inside.push_back(i);
  }
  const std::size_t moved = *rc::gen::elementOf(inside);
  const double by = *rc::gen::inRange(20, 5000) * 1e-4;  // noise of 0.0009 the other way at most
  rows[moved].at.z += *rc::gen::element(-1, 1) * by;
  const Verdict verdict = judge_samples(kPath, csv_of(rows));
  RC_LOG() << name(verdict.kind) << " " << verdict.message << " " << verdict.got;
  RC_ASSERT(verdict.kind == VerdictKind::fail_geometry);
  RC_ASSERT(verdict.record == moved);
}

}  // namespace
}  // namespace gonogo::oracle
