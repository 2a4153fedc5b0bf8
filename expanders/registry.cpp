// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/registry.hpp"

#include <array>

#include "expanders/common/subject_glue.hpp"
#include "expanders/gsk/interpreter.hpp"
#include "expanders/hnc/interpreter.hpp"
#include "expanders/ngc/interpreter.hpp"
#include "expanders/sinumerik/interpreter.hpp"

namespace gonogo::expanders {
namespace {

/// One maker's expander: fault 0 is none, fault i + 1 that of descriptions()[i].
struct Maker {
  std::string_view name;
  std::span<const FaultDescription> (*descriptions)();
  const gonogo_subject_v1& (*subject)(std::size_t fault);
  FaultCount (*count)(std::size_t fault);
};

template <typename Interpreter>
const gonogo_subject_v1& subject_of(std::size_t fault) {
  return SubjectGlue<Interpreter>::subject(static_cast<Fault>(fault));
}

template <typename Interpreter>
FaultCount count_of(std::size_t fault) {
  return SubjectGlue<Interpreter>::count(static_cast<Fault>(fault));
}

// These tell where the line of a fault ran, not whether it answered wrongly.
template <typename Interpreter>
FaultCount reached_of(std::size_t fault) {
  return {count_of<Interpreter>(fault).reached, std::nullopt};
}

template <const auto& kFaults>
std::span<const FaultDescription> listed() {
  return kFaults;
}

constexpr std::array<Maker, 4> kMakers = {{
    {"gsk", &listed<gsk::kFaults>, &subject_of<gsk::Interpreter>, &reached_of<gsk::Interpreter>},
    {"hnc", &listed<hnc::kFaults>, &subject_of<hnc::Interpreter>, &reached_of<hnc::Interpreter>},
    {"ngc", &listed<ngc::kFaults>, &subject_of<ngc::Interpreter>, &count_of<ngc::Interpreter>},
    {"sinumerik", &listed<sinumerik::kFaults>, &subject_of<sinumerik::Interpreter>,
     &reached_of<sinumerik::Interpreter>},
}};

const Maker* maker_of(std::string_view name) {
  for (const Maker& maker : kMakers) {
    if (maker.name == name) return &maker;
  }
  return nullptr;
}

// The number of a maker's fault, 0: of none; nothing: there is no such fault.
std::optional<std::size_t> number_of(const Maker& maker, std::string_view fault) {
  if (fault.empty()) return 0;
  const std::span<const FaultDescription> known = maker.descriptions();
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i].name == fault) return i + 1;
  }
  return std::nullopt;
}

}  // namespace

std::span<const std::string_view> names() {
  static constexpr std::array<std::string_view, 4> kNames = {kMakers[0].name, kMakers[1].name,
                                                             kMakers[2].name, kMakers[3].name};
  return kNames;
}

const gonogo_subject_v1* find(std::string_view name, std::string_view fault) {
  const Maker* maker = maker_of(name);
  const std::optional<std::size_t> number =
      maker != nullptr ? number_of(*maker, fault) : std::nullopt;
  return number ? &maker->subject(*number) : nullptr;
}

std::optional<FaultCount> count(std::string_view name, std::string_view fault) {
  const Maker* maker = maker_of(name);
  if (maker == nullptr) return std::nullopt;
  const std::optional<std::size_t> number = number_of(*maker, fault);
  return number ? std::optional(maker->count(*number)) : std::nullopt;
}

std::span<const FaultDescription> faults(std::string_view name) {
  const Maker* maker = maker_of(name);
  return maker == nullptr ? std::span<const FaultDescription>{} : maker->descriptions();
}

}  // namespace gonogo::expanders
