// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/model.hpp"

#include <algorithm>

#include "reference/dialect.hpp"

namespace gonogo::cover {

std::string codes_of(std::string_view dialect, std::initializer_list<std::string_view> features) {
  const reference::Dialect& known = *reference::find_dialect(dialect);
  std::string line = "code:";
  for (const reference::Code& code : known.descriptor->codes) {
    const bool acts =
        code.treatment == reference::Treatment::read && code.clause != reference::kNoClause;
    if (!acts || std::ranges::find(features, code.feature) == features.end()) continue;
    // Lathes are programmed with two digits.
    line += " " + (known.lathe ? code.text() : std::string(code.name));
  }
  return line + "\n";
}

std::string joined(std::initializer_list<std::string_view> texts) {
  std::string all;
  for (const std::string_view text : texts) all += text;
  return all;
}

std::vector<const Model*> models() {
  std::vector<const Model*> all;
  for (const std::span<const Model> some :
       {gsk_models(), hnc_models(), ngc_models(), sinumerik840d_models(), sinumerik802s_models()}) {
    for (const Model& model : some) all.push_back(&model);
  }
  return all;
}

const Model* find_model(std::string_view name) {
  for (const Model* model : models()) {
    if (model->name == name) return model;
  }
  return nullptr;
}

}  // namespace gonogo::cover
