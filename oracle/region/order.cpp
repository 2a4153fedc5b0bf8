// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/order.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/region/constants.hpp"
#include "oracle/region/distance_history.hpp"
#include "oracle/region/order_proof.hpp"

namespace gonogo::oracle::region {
namespace {

// For a reach that is less by so much.
Band narrowed(Band band, Interval by) {
  band.outer = band.outer - by;
  band.inner = band.inner + by;
  band.square_radii();
  return band;
}

}  // namespace

CutSequence::CutSequence(const PlanePoint& plunge, const Number& step, const Number& reach,
                         double width)
    : plunge_(enclose(plunge)), step_(enclose(step)), reach_(enclose(reach)), width_(width) {
  bands_.push_back(disc_about(plunge_, reach_));
}

void CutSequence::add_unit(const CutUnit& unit) {
  for (std::size_t i = unit.bands; i < bands_.size(); ++i) {
    bands_[i].unit = static_cast<std::uint32_t>(units_.size());
  }
  units_.push_back(unit);
}

void CutSequence::add(const Arc& arc, bool counterclockwise) {
  Stretch stretch = whole(arc);
  // What a circle does after its first turn is done.
  if (arc.round) stretch.turns = std::min(stretch.turns, 1);
  std::vector<Stretch> open{stretch};
  while (!open.empty() && !too_long_) {
    const Stretch part = open.back();
    open.pop_back();
    if (part.is_at_most_quarter()) {
      add_part(arc, part, counterclockwise);
      continue;
    }
    const auto parts = halves(part);
    open.push_back(parts[counterclockwise ? 1 : 0]);
    open.push_back(parts[counterclockwise ? 0 : 1]);
    too_long_ = units_.size() + open.size() > kMaximumBands;
  }
}

void CutSequence::add_part(const Arc& arc, const Stretch& stretch, bool counterclockwise) {
  CutUnit unit;
  unit.counterclockwise = counterclockwise;
  unit.c = arc.c;
  unit.stretch = stretch;
  const IntervalVector a = arc.c + stretch.a();
  const IntervalVector b = arc.c + stretch.b();
  unit.begin = counterclockwise ? a : b;
  unit.end = counterclockwise ? b : a;
  unit.record = arc.record;
  unit.bands = bands_.size();
  if (!append_stretch(arc, stretch, reach_, width_, bands_)) too_long_ = true;
  // An arc before it has a disc where it ends.
  if (units_.empty() || !units_.back().clears) bands_.push_back(disc_about(unit.begin, reach_));
  bands_.push_back(disc_about(unit.end, reach_));
  add_unit(unit);
}

void CutSequence::add_line(const Line& line, bool clears, std::size_t record) {
  CutUnit unit;
  unit.is_line = true;
  unit.clears = clears;
  unit.begin = line.a;
  unit.end = line.b;
  unit.record = record;
  unit.bands = bands_.size();
  if (clears) append_line(line.a, line.b, reach_, bands_);
  add_unit(unit);
}

// Walks the path in the order of time, in pieces that lie in one band each.
class OrderCheck {
 public:
  OrderCheck(const CutSequence& path, double half_side)
      : path_(path),
        units_(path.units_),
        bands_(path.bands_),
        distances_(units_),
        grid_(bands_, half_side, path.reach_.sup()),
        budget_(kPiecesPerUnit * units_.size() + kPiecesOnTop) {}

  CutOrder run();

 private:
  // A part of a unit; of an arc a stretch.
  struct Part {
    Stretch stretch;
    IntervalVector from;
    IntervalVector to;
  };
  using Piece = std::variant<CirclePiece, LinePiece>;

  std::optional<CutOrder> walk(std::size_t unit);
  std::optional<CutOrder> refute(std::size_t unit, const Part& part);
  bool is_supported(std::size_t unit, const Part& part);
  bool seems_supported(std::size_t unit, const IntervalVector& at) const;
  bool is_supported_nearer(std::size_t unit, const Piece& piece, const IntervalVector& middle,
                           Interval size) const;
  std::int64_t last_support(std::size_t unit, const IntervalVector& at, Interval size) const;
  bool lies_in(const Piece& piece, std::size_t band) const;
  Piece piece_of(const CutUnit& unit, const Part& part) const;
  IntervalVector middle_of(const CutUnit& unit, const Part& part) const;
  std::array<Part, 2> halves_of(const CutUnit& unit, const Part& part) const;
  void remember(std::size_t unit, std::size_t band, std::size_t place);

  const CutSequence& path_;
  const std::vector<CutUnit>& units_;
  const std::vector<Band>& bands_;
  DistanceHistory distances_;
  Grid grid_;
  std::size_t budget_;
  std::size_t proofs_ = 0;
  bool undecided_ = false;
  // How far back in the list the bands stand that held pieces lately, the latest first: the
  // turn before runs along.
  std::array<std::int64_t, 8> recent_{-1, -2, -3, -4, -5, -6, -7, -8};
};

IntervalVector OrderCheck::middle_of(const CutUnit& unit, const Part& part) const {
  if (unit.is_line) return Interval(0.5) * (part.from + part.to);
  return unit.c + region::middle_of(part.stretch);
}

std::array<OrderCheck::Part, 2> OrderCheck::halves_of(const CutUnit& unit, const Part& part) const {
  const IntervalVector middle = middle_of(unit, part);
  if (unit.is_line) return {Part{{}, part.from, middle}, Part{{}, middle, part.to}};
  const auto parts = halves(part.stretch);
  const std::size_t first = unit.counterclockwise ? 0 : 1;
  return {Part{parts[first], part.from, middle}, Part{parts[1 - first], middle, part.to}};
}

OrderCheck::Piece OrderCheck::piece_of(const CutUnit& unit, const Part& part) const {
  if (unit.is_line) return LinePiece{part.from, part.to};
  return part.stretch.circles(unit.c);
}

bool OrderCheck::lies_in(const Piece& piece, std::size_t band) const {
  return std::visit([&](const auto& curve) { return lies_inside(curve, bands_[band]); }, piece);
}

// The last unit that supports all places no farther than `size` from here; -1: none.
std::int64_t OrderCheck::last_support(std::size_t unit, const IntervalVector& at,
                                      Interval size) const {
  if (!units_[unit].clears) return static_cast<std::int64_t>(unit) - 1;
  return distances_.last_beyond(unit, at, path_.reach_ + size);
}

void OrderCheck::remember(std::size_t unit, std::size_t band, std::size_t place) {
  const std::size_t end = std::min(place, recent_.size() - 1);
  std::copy_backward(recent_.begin(), recent_.begin() + static_cast<std::ptrdiff_t>(end),
                     recent_.begin() + static_cast<std::ptrdiff_t>(end) + 1);
  recent_[0] = static_cast<std::int64_t>(band) - static_cast<std::int64_t>(units_[unit].bands);
}

bool OrderCheck::is_supported(std::size_t unit, const Part& part) {
  const CutUnit& whole_unit = units_[unit];
  const Piece piece = piece_of(whole_unit, part);
  if (lies_in(piece, 0)) return true;
  const IntervalVector middle = middle_of(whole_unit, part);
  const Interval spread = whole_unit.is_line ? Interval(0) : part.stretch.ra - part.stretch.rb;
  const Interval to_from = norm(part.from - middle);
  const Interval to_end = norm(part.to - middle);
  const double size = std::max(to_from.sup(), to_end.sup()) + abs(spread).sup();
  const std::int64_t last = last_support(unit, middle, {size, size});
  if (last < 0) return false;
  const auto counts = [&](std::size_t band) {
    return band > 0 && static_cast<std::int64_t>(bands_[band].unit) <= last;
  };
  for (std::size_t place = 0; place < recent_.size(); ++place) {
    const std::int64_t band = static_cast<std::int64_t>(whole_unit.bands) + recent_[place];
    if (band <= 0 || band >= static_cast<std::int64_t>(bands_.size())) continue;
    const auto index = static_cast<std::size_t>(band);
    if (!counts(index) || !lies_in(piece, index)) continue;
    remember(unit, index, place);
    return true;
  }
  for (const std::uint32_t band : grid_.near(median(middle.x()), median(middle.y()))) {
    if (!counts(band) || !lies_in(piece, band)) continue;
    remember(unit, band, recent_.size());
    return true;
  }
  const bool is_small = size * 16 < path_.reach_.inf();
  return whole_unit.clears && is_small && is_supported_nearer(unit, piece, middle, {size, size});
}

// The same for a smaller reach. Where the path was out of the larger one only just, or not quite,
// it was out of the smaller one.
bool OrderCheck::is_supported_nearer(std::size_t unit, const Piece& piece,
                                     const IntervalVector& middle, Interval size) const {
  const Interval less = 0.5 * (path_.reach_ - path_.step_);
  const std::int64_t last = distances_.last_beyond(unit, middle, path_.reach_ - less + size);
  for (const std::uint32_t index : grid_.near(median(middle.x()), median(middle.y()))) {
    if (index == 0 || static_cast<std::int64_t>(bands_[index].unit) > last) continue;
    const Band band = narrowed(bands_[index], less);
    if (std::visit([&](const auto& curve) { return lies_inside(curve, band); }, piece)) return true;
  }
  return false;
}

// A hint only.
bool OrderCheck::seems_supported(std::size_t unit, const IntervalVector& at) const {
  const std::int64_t last = last_support(unit, at, 0);
  const double x = median(at.x());
  const double y = median(at.y());
  for (const std::uint32_t band : grid_.near(x, y)) {
    const bool counts = band == 0 || static_cast<std::int64_t>(bands_[band].unit) <= last;
    if (counts && rough_distance(bands_[band], x, y) <= 0) return true;
  }
  return false;
}

// Where the part ends the path is farthest in; else somewhere in its middle.
std::optional<CutOrder> OrderCheck::refute(std::size_t unit, const Part& part) {
  if (proofs_ >= kMostTries) return std::nullopt;
  ++proofs_;
  const CutUnit& whole_unit = units_[unit];
  const auto halved = halves_of(whole_unit, part);
  std::optional<CutOrder> best;
  for (const bool at_end : {true, false}) {
    const Part upto{at_end ? part.stretch : halved[0].stretch, part.from,
                    at_end ? part.to : halved[0].to};
    Stretch behind = upto.stretch;  // of the unit, to the place
    if (whole_unit.counterclockwise) {
      behind.ua = whole_unit.stretch.ua;
      behind.ra = whole_unit.stretch.ra;
    } else {
      behind.ub = whole_unit.stretch.ub;
      behind.rb = whole_unit.stretch.rb;
    }
    const auto distance = distance_from_support(units_, unit, behind, upto.to,
                                                {path_.plunge_, path_.step_, path_.reach_});
    if (!distance || (best && best->distance >= to_number(*distance))) continue;
    best.emplace();
    best->kind = CutOrder::Kind::broken;
    best->record = whole_unit.record;
    best->witness = region::middle_of(upto.to);
    best->distance = to_number(*distance);
  }
  return best;
}

std::optional<CutOrder> OrderCheck::walk(std::size_t unit) {
  const CutUnit& whole_unit = units_[unit];
  std::vector<Part> open{{whole_unit.stretch, whole_unit.begin, whole_unit.end}};
  while (!open.empty()) {
    const Part part = open.back();
    open.pop_back();
    if (is_supported(unit, part)) continue;
    if (!seems_supported(unit, middle_of(whole_unit, part))) {
      if (auto broken = refute(unit, part)) return broken;
    }
    if (budget_ == 0 || !(norm(part.to - part.from).sup() > kEstimate)) {
      undecided_ = true;
      return std::nullopt;
    }
    --budget_;
    const auto parts = halves_of(whole_unit, part);
    open.push_back(parts[1]);
    open.push_back(parts[0]);
  }
  return std::nullopt;
}

CutOrder OrderCheck::run() {
  for (std::size_t unit = 0; unit < units_.size(); ++unit) {
    if (auto broken = walk(unit)) return *broken;
  }
  return {undecided_ ? CutOrder::Kind::undecided : CutOrder::Kind::fine, 0, {}, {}};
}

CutOrder CutSequence::check(double half_side) const {
  if (too_long_) return {CutOrder::Kind::undecided, 0, {}, {}};
  return OrderCheck(*this, half_side).run();
}

}  // namespace gonogo::oracle::region
