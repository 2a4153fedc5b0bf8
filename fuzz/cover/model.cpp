// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/cover/model.hpp"

namespace gonogo::fuzz::cover {

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

}  // namespace gonogo::fuzz::cover
