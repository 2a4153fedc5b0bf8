// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the GSK reference share: a program and a profile in, items and lines of text
// out.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/expander.hpp"

namespace gonogo::reference::testing {

using exact::Number;
using Lines = std::vector<std::string>;

// A number from its text; a text that is none throws.
Number num(std::string_view text);

// The default profile with these readings. Throws when a reading or its value is unknown.
Profile profile_with(
    std::initializer_list<std::pair<std::string_view, std::string_view>> readings = {});

// Everything that the reference says of a program: its last item is the `end` record, the alarm or
// not-covered.
std::vector<Item> expand(std::string_view program, const Profile& profile = {},
                         OpenPaths open_paths = OpenPaths::shown);

// One item as a line for comparisons, without its block:
//   rapid x35 z70            axes in the order x y z a c, true lengths
//   feed x0 f200             f200/rev under feed per revolution
//   arc x25 z51.5 c50.75,25 rot-1 f800       the centre along p and q
//   arc3 x10 y0 z0 via x5 y3 z4 f100
//   thread x29.35 z-28 lead3 start0
//   dwell 1.5 | m35 | end x0 y0 z0 a0 c0
//   level d40 c50,25 R16 r4 L3 -1 f800       an open level of a pocket
//   milling d2..-17 c60,40 60x40 R8 r4 Q4 +1 depth f150 plane f300   an open LCYC75
//   rename x0 y0 z-5 a0 c0                   the shift
//   alarm b3 tool-too-large step-too-large   classes in the order of their words
//   not-covered b2 G71
std::string line_of(const Item& item);
// All items of a program as such lines; without the `end` record.
Lines lines(std::string_view program, const Profile& profile = {},
            OpenPaths open_paths = OpenPaths::shown);
// The same with the open paths as the judge takes them.
Lines judged(std::string_view program, const Profile& profile = {});
// The lines of `blocks` after one line of `start`, the move to the start point.
Lines lines_after(const std::string& start, const std::string& blocks, const Profile& profile = {});
// The last line of a program: its `end` record, alarm or not-covered.
std::string ending(std::string_view program, const Profile& profile = {},
                   OpenPaths open_paths = OpenPaths::shown);
// The clause of each record, level and of the first alarm, in order; without the `end` record.
Lines clauses_of(std::string_view program, const Profile& profile = {},
                 OpenPaths open_paths = OpenPaths::shown);
// The classes that the alarm of a program admits, by name.
Lines admitted_classes_of(std::string_view program, const Profile& profile = {});
// The readings that a program touches, by name, in the order of the table.
Lines touched_readings(std::string_view program, const Profile& profile = {},
                       OpenPaths open_paths = OpenPaths::shown);

}  // namespace gonogo::reference::testing
