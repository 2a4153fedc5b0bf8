// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of a dialect, from decisions: valid, nearly valid, on boundaries, raw.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "fuzz/generate/choices.hpp"
#include "fuzz/generate/generator_settings.hpp"
#include "reference/profile.hpp"

namespace gonogo::generate {

// A program and the machine that it is for.
struct GeneratedProgram {
  reference::Profile profile;
  std::string text;
};

// Counts what the generated programs hold, by name ("g94 entry", "plane G19", "fault: sign", ...).
using Distribution = std::map<std::string, std::size_t>;

// The generator of one dialect, with the built-in expander that its programs try.
struct Generator {
  std::string_view dialect;   // "gsk988ta"
  std::string_view expander;  // "gsk"
  // The dialect's own writer; of every kind but raw.
  GeneratedProgram (*write)(Choices& choices, const GeneratorSettings& settings, ProgramKind kind,
                            Distribution* distribution);
  // Readings that stay open: none of the writer's programs asks for them, and a subject that does
  // not have what they are about need not know their alternatives; or our expander has one of them.
  std::span<const reference::ReadingKey> unasked;

  // A program of a kind that the settings have. `distribution` may be null.
  GeneratedProgram generate(Choices& choices, const GeneratorSettings& settings,
                            Distribution* distribution) const;
  // With the default settings.
  GeneratedProgram generate(Choices& choices, Distribution* distribution) const {
    return generate(choices, {}, distribution);
  }
};

std::span<const Generator> generators();
// By the name of a built-in expander, and its dialect; the first one where none is given. Null:
// none.
const Generator* find_generator(std::string_view expander, std::string_view dialect = {});

// By its dialect, which has to be one of them.
const Generator& generator_of(std::string_view dialect);

std::string_view name(ProgramKind kind);  // "near-invalid"

// Sets one reading of the profile's dialect to an alternative that need not be the default.
// Returns "name=value".
std::string choose_reading(Choices& choices, reference::Profile& profile);

}  // namespace gonogo::generate
