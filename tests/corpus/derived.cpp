// SPDX-License-Identifier: GPL-3.0-or-later
#include "derived.hpp"

#include <gtest/gtest.h>

#include "corpus_testing.hpp"

namespace gonogo::testing {
namespace {

using reference::Axis;
using reference::Record;
using reference::RecordKind;

std::string exact_text(const reference::Number& number) {
  return number.text();
}

}  // namespace

std::string line_of(const Record& record, NumberText text) {
  const auto point = [&](const std::string& prefix, reference::AxisSet axes,
                         const reference::Position& at) {
    std::string words;
    for (const Axis axis : reference::kAllAxes) {
      if (axes.has(axis)) words += " " + prefix + reference::letter(axis) + text(at[axis]);
    }
    return words;
  };
  std::string out;
  if (record.kind != RecordKind::end) out += std::to_string(record.block) + " ";
  out += reference::name(record.kind);
  if (record.kind == RecordKind::m) return out + " " + std::to_string(record.m);
  if (record.kind == RecordKind::dwell) return out + " " + text(record.seconds);
  if (record.kind == RecordKind::arc) {
    const reference::PlaneAxes axes = reference::axes_of(record.plane);
    reference::Position centre;
    centre[axes.p] = record.centre[0];
    centre[axes.q] = record.centre[1];
    out += " G" + std::to_string(reference::plane_code(record.plane)) + " " +
           std::to_string(record.rot) + point("c", {axes.p, axes.q}, centre);
  }
  if (record.kind == RecordKind::arc3)
    out += " via" + point("", record.via_axes, record.via) + " to";
  out += point("", record.axes, record.to);
  if (record.kind == RecordKind::feed || record.kind == RecordKind::arc ||
      record.kind == RecordKind::arc3) {
    out += " f" + text(record.feed);
    if (record.feed_mode == reference::FeedMode::per_revolution) out += "/rev";
  }
  if (record.kind == RecordKind::thread) out += " lead" + text(record.lead);
  return out;
}

Lines records_of(const std::string& id, std::size_t expectation) {
  Lines lines;
  for (const Record& record : checked_in_expectation(id, expectation).records) {
    lines.push_back(line_of(record, exact_text));
  }
  return lines;
}

Lines operator+(Lines a, const Lines& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace gonogo::testing
