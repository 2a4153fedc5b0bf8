// SPDX-License-Identifier: GPL-3.0-or-later
//
// What append_json writes, the reader reads back; and no text makes it do anything but answer.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracle/records/trace_reader.hpp"

namespace gonogo::oracle {
namespace {

using reference::Axis;
using reference::Plane;
using reference::Record;
using reference::RecordKind;

Number arbitrary_number() {
  const auto top = static_cast<std::int64_t>(*rc::gen::arbitrary<std::int32_t>());
  const auto bottom = *rc::gen::element<std::int64_t>(1, 3, 7, 1000, 1000000);
  const Number rational = Number(top) / Number(bottom);
  if (*rc::gen::inRange(0, 4) != 0) return rational;
  return Number::root(rational, Number(*rc::gen::inRange(1, 9)), Number(2));
}

Record arbitrary_record() {
  Record record;
  record.kind = static_cast<RecordKind>(*rc::gen::inRange(0, 8));
  record.block = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000));
  for (Axis axis : reference::kAllAxes) record.to[axis] = arbitrary_number();
  record.axes = reference::kEveryAxis;
  record.via_axes = reference::kEveryAxis;
  for (Axis axis : reference::kAllAxes) record.via[axis] = arbitrary_number();
  record.plane = static_cast<Plane>(*rc::gen::inRange(0, 3));
  record.rot = *rc::gen::element(-3, -1, 1, 2);
  record.centre = {arbitrary_number(), arbitrary_number()};
  record.feed = arbitrary_number();
  record.feed_mode = static_cast<reference::FeedMode>(*rc::gen::inRange(0, 2));
  record.lead = arbitrary_number();
  record.start = arbitrary_number();
  record.seconds = arbitrary_number();
  record.m = *rc::gen::inRange(0, 1000);
  return record;
}

RC_GTEST_PROP(TraceReader, ReadsWhatIsWritten, ()) {
  std::string written;
  append_json(arbitrary_record(), written);
  TraceReader reader;
  const TraceLine line = reader.read(written);
  if (auto* fault = std::get_if<TraceFault>(&line)) RC_FAIL(fault->message + "\n" + written);
  std::string again;
  append_json(std::get<Record>(line), again);
  RC_ASSERT(again == written);
}

RC_GTEST_PROP(TraceReader, AnswersWhateverByteIsChanged, ()) {
  std::string text;
  append_json(arbitrary_record(), text);
  const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
  text[at] = *rc::gen::arbitrary<char>();
  TraceReader reader;
  const TraceLine line = reader.read(text);
  if (auto* fault = std::get_if<TraceFault>(&line)) RC_ASSERT(!fault->message.empty());
}

}  // namespace
}  // namespace gonogo::oracle
