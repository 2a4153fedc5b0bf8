// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/parameters.hpp"

#include <algorithm>
#include <utility>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::rs274 {
namespace {

constexpr std::string_view kPredefined =
    "_a _abs_a _abs_b _abs_c _abs_u _abs_v _abs_w _abs_x _abs_y _abs_z _absolute "
    "_adaptive_feed _b _c _call_level _ccomp _coord_system _current_pocket _current_tool "
    "_feed _feed_hold _feed_override _flood _ijk_absolute_mode _imperial _incremental "
    "_inverse_time _lathe_diameter_mode _lathe_radius_mode _line _metric _mist _motion_mode "
    "_plane _remap_level _retract_old_z _retract_r_plane _rpm _selected_pocket "
    "_selected_tool _speed_override _spindle_css_mode _spindle_cw _spindle_on "
    "_spindle_rpm_mode _task _tool_offset _u _units_per_minute _units_per_rev _v _value "
    "_value_returned _vmajor _vminor _w _x _y _z";

bool is_argument(std::int64_t number) {
  return number <= static_cast<std::int64_t>(kArguments);
}

bool is_global(const std::string& name) {
  return name.starts_with('_');
}

}  // namespace

Value Parameters::numbered(std::int64_t number) const {
  if (is_argument(number)) return owner().arguments[static_cast<std::size_t>(number - 1)];
  const auto found = numbered_.find(number);
  return found == numbered_.end() ? Value() : found->second;
}

void Parameters::set(std::int64_t number, Value value) {
  if (is_argument(number)) {
    const auto place = static_cast<std::size_t>(number - 1);
    owner().arguments[place] = std::move(value);
    owner().inherited[place] = false;
  } else {
    numbered_[number] = std::move(value);
  }
}

bool Parameters::is_inherited(std::int64_t number) const {
  return is_argument(number) && owner().inherited[static_cast<std::size_t>(number - 1)];
}

std::optional<Value> Parameters::named(const std::string& name) const {
  const std::map<std::string, Value>& all = is_global(name) ? global_ : levels_.back().named;
  const auto found = all.find(name);
  if (found == all.end()) return std::nullopt;
  return found->second;
}

void Parameters::set(const std::string& name, Value value) {
  (is_global(name) ? global_ : levels_.back().named)[name] = std::move(value);
}

void Parameters::enter(std::vector<Value> arguments) {
  Level level{owner().arguments, {}, {}, levels_.size()};
  const auto given = static_cast<std::ptrdiff_t>(arguments.size());
  std::fill(level.inherited.begin() + given, level.inherited.end(), true);
  std::ranges::move(arguments, level.arguments.begin());
  levels_.push_back(std::move(level));
}

void Parameters::enter_sharing() {
  levels_.push_back({{}, {}, {}, levels_.back().owner});
}

bool is_predefined(std::string_view name) {
  return name.starts_with("_ini[") || name.starts_with("_hal[") || has_name(kPredefined, name);
}

}  // namespace gonogo::reference::rs274
