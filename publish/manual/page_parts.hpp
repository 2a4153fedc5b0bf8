// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a dialect's page. Private to page.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "publish/manual/examples.hpp"
#include "publish/manual/page.hpp"
#include "publish/report/figure.hpp"

namespace gonogo::oracle::manual {

// A page as it grows.
struct PageDraft {
  std::string_view dialect;
  bool lathe = false;
  std::string text;
  std::vector<PageFile> drawings;
};

void append_clauses(PageDraft& page, std::span<const reference::Clause* const> clauses);
// The program, its drawing and its motions, each with its clause.
void append_example(PageDraft& page, const Example& example);
// What each value of the reading makes of the example, and drawings of those that differ.
void append_reading(PageDraft& page, const reference::Reading& reading,
                    const ReadingExample& example);
void append_alarms(PageDraft& page, const std::vector<const AlarmExample*>& alarms);
void append_codes(PageDraft& page, const reference::Dialect& dialect);
void append_outside(PageDraft& page, const reference::Dialect& dialect);

}  // namespace gonogo::oracle::manual
