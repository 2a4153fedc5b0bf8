// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/thread_passes.hpp"

#include "reference/clause_literal.hpp"
#include "reference/rs274/idle.hpp"

namespace gonogo::reference::rs274 {

// J n^(1/R); R = u/v.
Number ThreadPasses::depth(const Number& n) const {
  return words.first_depth * exact::power(n, words.degression_divisor, words.degression);
}

Number ThreadPasses::cut(const Number& depth) const {
  return start[Axis::x] + side * (abs(words.peak) + depth);
}

Number ThreadPasses::withdrawn(const Number& depth) const {
  return start[Axis::x] - side * (words.full_depth - depth);
}

Number ThreadPasses::begin(const Number& depth) const {
  const Number& z0 = start[Axis::z];
  if (equal_lengths) return z0 - forward * (words.full_depth - depth) * words.tangent;
  return z0 + forward * depth * words.tangent;
}

Number ThreadPasses::end(const Number& depth) const {
  return words.end[Axis::z] - forward * (words.full_depth - depth) * words.tangent;
}

namespace {

// Records of a pass, along X or along X and Z.
class Motions {
 public:
  explicit Motions(const ThreadPasses& passes) : passes_(passes) {}

  Record rapid(ClauseId clause, const Number& x) const { return to(RecordKind::rapid, clause, x); }
  Record rapid(ClauseId clause, const Number& x, const Number& z) const {
    return along_z(rapid(clause, x), z);
  }
  // The main cut.
  Record thread(ClauseId clause, const Number& x, const Number& z) const {
    return with_lead(along_z(to(RecordKind::thread, clause, x), z), passes_.words.lead);
  }
  // NGC-G76-11: P along Z; of the record along the longer axis.
  Record taper(const Number& x, const Number& z) const {
    const ThreadWords& words = passes_.words;
    const Number& longer = max(words.taper, words.full_depth);
    return with_lead(along_z(to(RecordKind::thread, "NGC-G76-11"_clause, x), z),
                     words.lead * longer / words.taper);
  }
  // NGC-G76-09: to where the taper begins, with the lead of the taper's path.
  Record entry(const Number& x) const {
    const ThreadWords& words = passes_.words;
    const ClauseId clause = "NGC-G76-09"_clause;
    if (passes_.words.entry == TaperEntry::rapid) return rapid(clause, x);
    if (passes_.words.entry == TaperEntry::feed) return to(RecordKind::feed, clause, x);
    const Number path = sqrt(words.taper * words.taper + words.full_depth * words.full_depth);
    return with_lead(to(RecordKind::thread, clause, x), words.lead * path / words.taper);
  }

 private:
  Record to(RecordKind kind, ClauseId clause, const Number& x) const {
    Record record = record_of(kind, passes_.line, clause);
    record.axes.add(Axis::x);
    record.to[Axis::x] = x;
    if (kind == RecordKind::feed) {
      record.feed = passes_.feed_in_force;
      record.feed_mode = passes_.feed_mode;
    }
    return record;
  }
  static Record along_z(Record record, const Number& z) {
    record.axes.add(Axis::z);
    record.to[Axis::z] = z;
    return record;
  }
  static Record with_lead(Record record, const Number& lead) {
    record.lead = lead;
    return record;
  }

  const ThreadPasses& passes_;
};

Generator<Item> run_pass(const ThreadPasses& passes, Number depth) {
  const Motions motions(passes);
  const Number cut = passes.cut(depth);
  const Number crest = cut - passes.side * passes.words.full_depth;  // where tapers begin and end
  const Number withdrawn = passes.withdrawn(depth);
  const Number begin = passes.begin(depth);
  const Number end = passes.end(depth);
  const Number taper = passes.forward * passes.words.taper;
  co_yield motions.rapid("NGC-G76-09"_clause, withdrawn, begin);
  if (passes.words.enters_by_taper()) {
    co_yield motions.entry(crest);
    co_yield motions.taper(cut, begin + taper);
  } else {
    co_yield motions.rapid("NGC-G76-09"_clause, cut);
  }
  if (passes.words.leaves_by_taper()) {
    co_yield motions.thread("NGC-G76-10"_clause, cut, end - taper);
    co_yield motions.taper(crest, end);
  } else {
    co_yield motions.thread("NGC-G76-10"_clause, cut, end);
  }
  co_yield motions.rapid("NGC-G76-12"_clause, withdrawn);
}

Generator<Item> all_passes(ThreadPasses passes) {
  for (Number n = 1; passes.words.is_part_of_depth(n); n += 1) {
    Generator<Item> pass = run_pass(passes, passes.depth(n));
    while (const Item* item = pass.next()) co_yield *item;
  }
  for (Number k = 0; k <= passes.words.spring_passes; k += 1) {
    Generator<Item> pass = run_pass(passes, passes.words.full_depth);
    while (const Item* item = pass.next()) co_yield *item;
  }
  // NGC-G76-12
  const Position& end = passes.words.end;
  Record last = Motions(passes).rapid("NGC-G76-12"_clause, end[Axis::x], end[Axis::z]);
  last.axes.add(Axis::y);
  last.to[Axis::y] = end[Axis::y];
  co_yield last;
}

}  // namespace

Generator<Item> run_passes(ThreadPasses passes) {
  const Position start = passes.start;
  return without_idle(all_passes(std::move(passes)), start);
}

}  // namespace gonogo::reference::rs274
