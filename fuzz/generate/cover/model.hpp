// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models: what the programs of a cycle are varied in, and how a program is written from a choice.
// One table a dialect.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/generate/cover/covering_array.hpp"
#include "fuzz/generate/cover/drawing.hpp"

namespace gonogo::cover {

struct Model {
  std::string_view name;  // "gsk.g94"; the ids of its cases begin with it
  // Raised whenever other programs come of the model: an id never changes its meaning.
  unsigned version;
  std::string_view dialect;
  std::string_view cycle;     // of the vector file
  Strength strength;          // that the corpus is made with
  std::string_view features;  // "basic g94"
  std::string_view clauses;   // that it is about: "GSK-G94-01..12 GSK-COM-01"
  std::string parameters;     // as parse_parameters reads them
  void (*draw)(const Pick& pick, Drawing& drawing);
};

// In fuzz/generate/cover/<dialect>.cpp.
std::span<const Model> gsk_models();
std::span<const Model> hnc_models();
std::span<const Model> ngc_models();
std::span<const Model> sinumerik840d_models();
std::span<const Model> sinumerik802s_models();
// Models of these tables that stand in files of their own.
Model gsk_g110_model();
Model gsk_g112_model();
Model gsk_g114_model();
Model hnc_sequence_model();
Model sinumerik840d_sequence_model();

// The parameter `code`: what the dialect's table has under these features, as its maker writes it.
std::string codes_of(std::string_view dialect, std::initializer_list<std::string_view> features);
// Texts of parameters, one after the other.
std::string joined(std::initializer_list<std::string_view> texts);

std::vector<const Model*> models();
// Null: there is none of that name.
const Model* find_model(std::string_view name);

}  // namespace gonogo::cover
