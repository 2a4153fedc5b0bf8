// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the page asks and is answered. Both are a line of JSON and, behind it, plain text: of a request
// the program, of an answer the records as `gonogo expand` writes them.
#pragma once

#include <string>
#include <string_view>

namespace gonogo::playground {

// A request: {"dialect", "profile": lines of TOML or a JSON object as text, "readings": ["key=value"],
// "file": the program's name in messages, "draw": whether motions are wanted besides, "most": the records
// after which it is broken off; none: never}.
// The answer: {"exit": that of `gonogo expand`, "messages": what it says on standard error, "readings":
// those that the program asked for, with the value in force, "stopped": whether it was broken off}; drawn, "lathe", "steps": [{"b", "text",
// "clause"}] a record each, "moves" and "limits" as publish/report/page_paths.hpp has them, "cut": whether
// there is more than is drawn. A request that cannot be carried out has exit 2, its reason as messages and
// no records.
std::string answer(std::string_view request);

// The dialects, and of each its clauses and readings, as JSON.
std::string catalog();

}  // namespace gonogo::playground
