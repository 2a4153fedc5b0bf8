// SPDX-License-Identifier: GPL-3.0-or-later
//
// What LinuxCNC's documents say of parameters, expressions and O words.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog::rs274 {

inline constexpr std::string_view kParameters = "LinuxCNC 2.9, G-code overview: parameters";
inline constexpr std::string_view kExpressions =
    "LinuxCNC 2.9, G-code overview: expressions, operators and functions";
inline constexpr std::string_view kOCodes = "LinuxCNC 2.9, O codes";

inline constexpr auto kCalculationClauses = std::to_array<Clause>({
    {"NGC-PAR-01", must, kParameters,
     "# and a number, or a value, is a numbered parameter, from #1 to #5602; the number is whole. "
     "#1 to #5000 are the program's, and 0 until they are set.",
     "reference/rs274/expression.cpp"},
    {"NGC-PAR-02", must, kParameters,
     "A setting, #3=15, takes effect once all values of its line have been found; of two settings "
     "of a parameter the last one holds.",
     "reference/rs274/expression.cpp"},
    {"NGC-PAR-03", must, kParameters,
     "#<name> is a named parameter; the case of its letters and blanks do not count: with _ "
     "before it that of the whole program, else of the subroutine or the pass of a subprogram that "
     "set it, and gone when that ends. To use one that was never set is an alarm.",
     "reference/rs274/expression.cpp"},
    {"NGC-PAR-04", must, kParameters,
     "Parameters above #5000 and names of the language's own say what is in force. Read are #5220, "
     "#5420 to #5423 and #5425 (the position, in coordinates and units of the program), #<_x> "
     "#<_y> #<_z> #<_a> #<_c>, #<_plane> and #<_coord_system> (ten times the G code), #<_feed> "
     "while the units are those of F, #<_value> and #<_value_returned>; and as 1 or 0 #<_metric> "
     "#<_imperial> #<_absolute> #<_incremental> #<_ijk_absolute_mode>, #<_inverse_time> "
     "#<_units_per_minute> #<_units_per_rev>, #<_spindle_on> #<_spindle_cw> #<_spindle_css_mode> "
     "#<_spindle_rpm_mode>, #<_mist> and #<_flood>. #5599, which says whether messages are shown, "
     "is 1 until it is set. The others, and their settings, the gauge does not read.",
     "reference/rs274/expression.cpp"},
    {"NGC-EXP-01", must, kExpressions,
     "In brackets ** goes before * / MOD, these before + -, then EQ NE GT GE LT LE, then AND OR "
     "XOR; of one group the left one is first. # goes before all of them.",
     "reference/rs274/expression.cpp"},
    {"NGC-EXP-09", open, kExpressions,
     "AND, OR and XOR come last, as LinuxCNC's documents have it; to NIST's interpreter, which has "
     "no comparisons, they are of the group of + and -.",
     "reference/rs274/logic_order.cpp", Basis::text},
    {"NGC-EXP-02", must, kExpressions,
     "Comparisons and AND OR XOR give 1 or 0, and what is not zero is true. EQ and NE take values "
     "for equal that differ by less than a millionth, as the documents say, or a ten-thousandth, "
     "as "
     "LinuxCNC 2.9 has it.",
     "reference/rs274/operators.cpp"},
    {"NGC-EXP-03", must, kExpressions,
     "ABS, SQRT; FIX is the whole number below and FUP that above, ROUND the nearest one; SIN COS "
     "TAN of degrees, ASIN ACOS and ATAN[y]/[x] in degrees; EXISTS whether a named parameter was "
     "set.",
     "reference/rs274/operators.cpp"},
    {"NGC-EXP-04", open, kExpressions,
     "MOD leaves what is not below zero, ROUND takes halves away from zero, and ATAN gives -180 to "
     "180. No text says so, NIST's interpreter and LinuxCNC have it; our judgement.",
     "reference/rs274/operators.cpp"},
    {"NGC-EXP-05", open, kExpressions,
     "A sign before a parameter, brackets or a function changes its sign in LinuxCNC; in the texts "
     "a "
     "sign belongs to digits.",
     "reference/rs274/operators.cpp"},
    {"NGC-EXP-06", derived, kExpressions,
     "A division by zero, SQRT of a number below zero, ASIN and ACOS of one above 1, and a "
     "negative "
     "power of zero are alarms.",
     "reference/rs274/operators.cpp"},
    {"NGC-EXP-07", open, kExpressions,
     "EXP, LN, powers whose exponent is not whole, TAN of a right angle, MOD 0 and ATAN[0]/[0] are "
     "not read, nor what grows beyond what the gauge keeps.",
     "reference/rs274/expression.cpp"},
    {"NGC-EXP-08", open, kExpressions,
     "Where numbers that doubles have not exactly come within 2^-32 of what decides a comparison, "
     "a "
     "condition, FIX, FUP, ROUND, MOD, a division by zero or a root, or count a repeat, doubles "
     "may "
     "decide otherwise: not read.",
     "reference/rs274/operators.cpp"},
    {"NGC-OWD-01", must, kOCodes,
     "The lines from sub to endsub run when the label is called, and not where they stand. A "
     "subroutine is no part of another one, and has a label of its own.",
     "reference/rs274/o_words.cpp"},
    {"NGC-OWD-02", must, kOCodes,
     "call gives up to 30 values in brackets, which are #1, #2 and so on in the subroutine; the "
     "others up to #30 have there what they had, or zero in LinuxCNC 2.9. After it #1 to #30 are "
     "as "
     "before.",
     "reference/rs274/o_words.cpp"},
    {"NGC-OWD-03", must, kOCodes,
     "return and endsub end a call; only endsub needs its label. A value behind them is #<_value>, "
     "and #<_value_returned> is 1; "
     "both are 0 from the next call on, M98 among them, until one returns a value.",
     "reference/rs274/o_words.cpp"},
    {"NGC-OWD-04", must, kOCodes,
     "From if, elseif and else to endif the lines behind the first condition that is true run, or "
     "those behind else; no later condition is looked at, and no line that does not run.",
     "reference/rs274/o_words.cpp"},
    {"NGC-OWD-05", must, kOCodes,
     "while to endwhile run as long as the condition before them is true, do to while until the "
     "one "
     "behind them is not.",
     "reference/rs274/o_words.cpp"},
    {"NGC-OWD-06", must, kOCodes,
     "break leaves the loop of its label, a while or a do; continue goes to its next condition.",
     "reference/rs274/o_words.cpp"},
    {"NGC-OWD-07", must, kOCodes, "repeat to endrepeat run as often as the value says.",
     "reference/rs274/o_words.cpp"},
    {"NGC-OWD-08", must, kOCodes,
     "An O word whose label belongs to no open condition, loop or subroutine of its kind, a label "
     "that has another one already, and other words in the line are alarms.",
     "reference/rs274/o_words.cpp"},
    refused_by_some(
        {"NGC-OWD-09", open, kOCodes,
         "A comment behind an O word is ignored. No text says what it does; our judgement.",
         "reference/rs274/o_words.cpp", Basis::silent},
        "syntax"),
    {"NGC-OWD-10", open, kOCodes,
     "Calls of what the program does not have (a file may), labels that are calculated but for "
     "calls, "
     "more than nine calls within each other, repeat by no whole number, and programs beyond a "
     "mebibyte of lines that may come again or a hundred thousand lines that do are not read.",
     "reference/rs274/o_words.cpp"},
    refused_by_some({"NGC-OWD-11", open, kOCodes,
                     "A call of a subroutine that stands behind it runs it, and the program skips "
                     "it where it comes to it. The documents have it stand before. No text "
                     "says what happens else; our judgement.",
                     "reference/rs274/o_words.cpp", Basis::silent},
                    "syntax undefined-code"),
    {"NGC-OWD-13", must, kOCodes,
     "M98 P calls the subprogram that stands behind it, from the line O and its number to M99, and "
     "L times, once without L; #1 to #30 are those of the lines that call it. A subroutine of one "
     "style with a call, a return or an end of the other is an alarm, and so are P and L that are "
     "no whole numbers from 0 on. "
     "M99 "
     "in the program itself, and M98 and M99 beside other words, are not read.",
     "reference/rs274/subprograms.cpp"},
    {"NGC-OWD-14", open, kOCodes,
     "M98 of a subprogram that stands before it in the file is an alarm, as the documents have it. "
     "LinuxCNC runs one that has run already, and controls whose subprograms are files of their "
     "own know no order.",
     "reference/rs274/subprograms.cpp", Basis::text},
    {"NGC-OWD-12", open, kOCodes, "A comment between the values of a call is not read.",
     "grammar/x3/rs274.cpp"},
});

}  // namespace gonogo::reference::catalog::rs274
