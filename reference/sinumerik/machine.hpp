// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modal state of a SINUMERIK, and what a block sees of it. Positions and poles are in workpiece
// coordinates; records are in base coordinates, which put_motion() makes of them by the frame.
#pragma once

#include "reference/block_base.hpp"
#include "reference/geometry/kernel.hpp"
#include "reference/sinumerik/codes.hpp"
#include "reference/sinumerik/frame.hpp"
#include "reference/sinumerik/words.hpp"

namespace gonogo::reference::sinumerik {

using geometry::Point_2;
using geometry::Vector_2;

// R123 of a cycle behind which no F has stood.
struct FeedOfCycle {
  Number feed;
  bool replaces_one_of_before = false;  // F in force stood before the feed changed
};

// The last M6, and the T in force behind its block.
struct ToolChange {
  std::optional<Number> tool;
  bool is_done = false;  // its block has been read
};

// What is known of the machine's place in a plane beside its coordinates, which may be enclosures:
// its exact distance from a point, and the polar coordinates that it was sent to.
struct PlaceMark {
  Plane plane = Plane::g17;
  Point_2 centre;   // the pole, or the centre of an arc
  Number radius_2;  // mm^2
  struct Polar {
    Number radius;  // RP
    Number angle;   // AP
  };
  std::optional<Polar> polar;  // about `centre`
};

// What a direction at the end of an arc depends on beside the radius there.
struct LastArc {
  Vector_2 from_centre;  // to the start
  Vector_2 to_end;       // from the centre
  bool closed = false;
  int rot = 0;
  struct Climb {
    Axis axis = Axis::z;
    Number height;
  };
  std::optional<Climb> climb;  // of a helix
};

// SIE-CT-02: the last motion that has a length.
struct LastMotion {
  Position direction;  // at its end; of any length, for a helix without its climb
  std::optional<LastArc> arc;
  bool undecided = false;  // of a line: its direction is unknown
};

// What polar words count from, and which of them hold on.
struct PolarState {
  Point_2 pole;
  bool pole_is_put = false;            // by G110, G111 or G112 since the plane was chosen
  bool pole_is_of_before = false;      // a frame has changed since
  std::optional<Number> polar_angle;   // AP in force
  std::optional<Number> polar_radius;  // RP in force, mm
};

struct Machine : MotionState, PolarState {
  Control control = Control::sinumerik840d;
  WordModes modes;
  std::optional<Motion> motion;         // none: no code of the group was there
  int spindle = 5;                      // M3, M4, M5
  Number speed;                         // S
  bool speed_given = false;             // S counts as above zero though it is not known
  bool constant_cutting_speed = false;  // G96, G961
  bool turns_unknown = false;           // S was a cutting speed: G97 keeps what came of it
  bool spindle_is_placed = false;       // SPOS, SPOSA, M19, M70 or M6 behind M3, M4 and M5
  bool feed_is_of_before = false;       // F stood before the feed changed between G94 and G95
  bool feed_is_zero = false;            // the last F was 0
  // Until a block shows whether it is in force; and that it is, in millimetres.
  std::optional<FeedOfCycle> feed_of_cycle;
  bool feed_is_of_cycle = false;
  Frame frame;
  Position base;               // `position` in base coordinates; exact where that is only enclosed
  std::optional<Number> tool;  // T; none before any T word, or T0
  std::optional<ToolChange> last_m6;
  Number edge = 1;  // D
  // Changes of the translation since each axis moved, in base coordinates.
  Position untravelled;
  // Before a code of the plane in force, until a block shows whether it has held on.
  std::optional<PolarState> polar_before;
  std::optional<PlaceMark> mark;
  std::optional<LastMotion> last;
};

// Where a block goes.
struct EndPoint {
  AxisSet named;
  Position to;
  Position by;                    // to - position, exact also where both are only enclosed
  std::optional<PlaceMark> mark;  // what is known of `to`
  // Whether it is the start in the plane in force, where that is known.
  std::optional<bool> closed;
};

// One block in the hands of the file that carries its code.
struct BlockContext : BlockBase {
  Machine& machine;
  const BlockWords& words;
  const BlockCodes& codes;

  PlaneAxes plane_axes() const { return axes_of(machine.plane); }
  void put_item(Item item) { out.items.push_back(std::move(item)); }
  Point_2 position_in(const PlaneAxes& axes) const {
    return geometry::point_in(axes, machine.position);
  }
};

// An arc, ready to be put out.
struct ArcPath {
  Plane plane = Plane::g17;
  Point_2 centre;
  Vector_2 offset;  // centre - start
  int rot = 0;
  ClauseId clause = kNoClause;
};

// In alone.cpp. An alarm for each word beside the code of the block that holds once, except words
// of its own; where the block has several such codes, for each that stands beside a frame. Whether
// the call of a cycle stands alone; the same alarms.
void refuse_all_but(BlockContext& block, std::initializer_list<Address> its_own);
void refuse_beside_frame(BlockContext& block);
bool cycle_stands_alone(BlockContext& block);

// In feed_and_speed.cpp. F and S of a block without a dwell; the code of the feed. The third says
// of the block that it runs on with a T, D or H that some control refuses.
void take_feed_and_speed(BlockContext& block);
void take_feed_mode(BlockContext& block);
void accept_odd_numbers(BlockContext& block);

// In basic_motion.cpp.
// The feed in force of linear axes: F is millimetres, or under G70 and sie.g70.f = inch inches.
Number linear_feed(const BlockContext& block);
void run_dwell(BlockContext& block);
void run_line(BlockContext& block, RecordKind kind);
// The alarms of a cutting motion that has no feed, or no spindle that turns.
void need_cutting(BlockContext& block);
// Lets the feed go that a change of G94 and G95 has deleted.
void drop_feed_of_before(BlockContext& block);
void need_spindle(BlockContext& block);
// Whether the spindle turns; says of the block that it runs on where no text says whether.
bool spindle_turns(BlockContext& block);
// A straight motion, and an arc: they move the machine.
void put_line(BlockContext& block, RecordKind kind, ClauseId clause, const EndPoint& end);
void put_arc(BlockContext& block, const ArcPath& arc, const EndPoint& end);
// Completes the feed of a cutting record and puts it out.
void put_motion(BlockContext& block, const EndPoint& end, Record record);
// Puts out a motion to `end`, both in workpiece coordinates; `standing` are axes that stay.
void put_in_base(BlockContext& block, Record record, const Position& end, AxisSet standing = {});
// An alarm for each word of the block that is among these.
void refuse_words(BlockContext& block, std::initializer_list<Address> addresses);
// An alarm where TURN= adds turns.
void refuse_turns(BlockContext& block);

// In other_classes.cpp.
void admit_other_classes(BlockContext& block);

// In polar.cpp. The end point of the block's axis words, Cartesian or polar; nothing after an
// alarm.
std::optional<EndPoint> end_point(BlockContext& block);
// What an increment along the axis goes beside its number.
Number untravelled_along(const BlockContext& block, Axis axis);
void run_pole(BlockContext& block);
void take_plane(Machine& machine, Plane plane);
// Whether the pole, AP and RP have held on over a code of the plane in force, where the block shows
// it.
void settle_pole(BlockContext& block);

// In arc.cpp, cip.cpp, ct.cpp.
void run_arc(BlockContext& block, int sense);
void run_intermediate(BlockContext& block);
void run_tangent(BlockContext& block);
// The direction of a motion at its end, of a helix with its climb.
Position whole_direction(const LastMotion& last);

// In frame.cpp.
void run_translation(BlockContext& block);
void run_rotation(BlockContext& block);
// Whether a translation has changed since an axis moved, as it never does on the 840D.
bool has_untravelled(const Machine& machine);
// The axes move, and stand in the frame in force.
void travel(Machine& machine, AxisSet axes);
// What no text says of a frame in force: such a block is not covered.
void leave_out_frames(BlockContext& block);
// Whether the rotation in force admits the plane; else the alarm is given, at `word`.
bool admits_plane(BlockContext& block, Plane plane, WordName word);

// In vectors.cpp. Whether one of the numbers is not zero. Undecided is thrown only where none
// shows.
bool any_nonzero(std::initializer_list<Number> numbers);
// The way from the centre of an arc to its end, rational where that is known.
Vector_2 from_centre_to_end(const PlaneAxes& axes, const Point_2& centre, const Vector_2& offset,
                            const EndPoint& end);
// Whether it can be shown that two points are one.
bool surely_equal(const Point_2& a, const Point_2& b);

}  // namespace gonogo::reference::sinumerik
