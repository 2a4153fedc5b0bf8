// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/features.hpp"

#include <vector>

#include "reference/dialect.hpp"

namespace gonogo::oracle {

std::span<const Feature> feature_vocabulary() {
  static const std::vector<Feature> kVocabulary = [] {
    std::vector<Feature> all = {
        {"", "blocks", "records and alarms carry `b`, the source line; it is compared"},
        {"", "m", "M functions are passed on as records; they are compared"},
        {"", "bytes", "programs that are not UTF-8 are taken as base64"},
    };
    for (const reference::Dialect& dialect : reference::dialects()) {
      for (const reference::DialectFeature& feature : dialect.descriptor->features) {
        all.push_back({dialect.name, feature.name, feature.text});
      }
    }
    return all;
  }();
  return kVocabulary;
}

}  // namespace gonogo::oracle
