// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "reference/dialect.hpp"

namespace gonogo::cover {

using reference::Increment;
using reference::Profile;

bool Pick::has(std::string_view parameter) const {
  return std::ranges::find(parameters_.list, parameter, &Parameter::name) != parameters_.list.end();
}

const Class& Pick::class_of(std::string_view parameter) const {
  const std::size_t p = parameters_.find(parameter);
  return parameters_.list[p].classes[row_[p]];
}

const std::string& Pick::operator[](std::string_view parameter) const {
  return class_of(parameter).value;
}

bool Pick::is(std::string_view parameter, std::string_view class_name) const {
  return has(parameter) && class_of(parameter).name == class_name;
}

std::string_view last_line(std::string_view dialect) {
  return dialect == "rs274" ? "M2\n" : "";
}

std::string_view opening(std::string_view dialect) {
  return dialect.starts_with("sinumerik") ? " S400 M3" : "";
}

std::string own_text(std::string program, std::string_view dialect) {
  const std::string_view last = last_line(dialect);
  if (program.ends_with(last)) program.resize(program.size() - last.size());
  const std::size_t place = program.find(opening(dialect));
  if (place < program.find('\n')) program.erase(place, opening(dialect).size());
  return program;
}

std::string Drawing::program() const {
  const std::string_view last = last_line(dialect_);
  return text.ends_with(last) ? text : text + std::string(last);
}

Drawing::Drawing(const Pick& pick, std::string_view dialect)
    : profile(std::get<Profile>(reference::default_profile(dialect))),
      pick_(pick),
      dialect_(dialect),
      table_(*reference::find_dialect(dialect)->descriptor),
      lathe_(reference::find_dialect(dialect)->lathe),
      plane_(lathe_ ? 18 : 17),
      decimals_(dialect == "rs274" || pick.is("units", "inch") ? 4 : 3) {
  if (pick.has("plane")) plane_ = std::atoi(pick["plane"].c_str() + 1);
  if (pick.is("increment", "ISC")) {
    profile.increment = Increment::isc;
    ++decimals_;
  }
  if (pick.has("x")) profile.x_diameter = pick.is("x", "diameter");
  if (pick.has("reading") && !pick.is("reading", "default")) take_reading(pick["reading"]);
}

void Drawing::take_reading(const std::string& reading) {
  const std::size_t place = reading.find('=');
  if (auto error = reference::set_reading(profile, reading.substr(0, place),
                                          reading.substr(std::min(place + 1, reading.size())))) {
    throw ModelError(error->message);
  }
}

std::size_t Drawing::axis(Role role) const {
  constexpr std::array<std::array<std::size_t, 3>, 3> kAxes = {{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
  return kAxes[static_cast<std::size_t>(plane_ - 17)][static_cast<std::size_t>(role)];
}

Length Drawing::scaled(Role role, Length way) const {
  return profile.x_diameter && axis(role) == 0 ? 2 * way : way;
}

std::string Drawing::unit_code() const {
  if (!pick_.is("units", "inch")) return "";
  return std::string(table_.find(reference::Setting::inch)->name);
}

void Drawing::stand(Length p, Length q, Length d, std::string_view more) {
  at_ = {p, q, d};
  std::vector<std::string> words = {unit_code()};
  if (pick_.has("plane")) words.push_back(fmt::format("G{}", plane_));
  const reference::Code& traverse = *table_.find(reference::Kind::traverse);
  words.push_back(lathe_ ? traverse.text() : std::string(traverse.name));
  for (const Role role : {Role::p, Role::q, Role::d}) {
    if (!traverse.takes(letter(role))) continue;  // of two axes
    words.push_back(absolute(role, {}));
  }
  words.emplace_back(more);
  put(words);
  const bool turns = pick_.has("spindle") || more.find("M3") != std::string_view::npos;
  if (!turns) text.insert(text.size() - 1, opening(dialect_));
  if (pick_.is("distance", "modal") || pick_.is("distance", "AC")) {
    put({std::string(table_.find(reference::Setting::incremental)->name)});
  }
}

void Drawing::put(const std::vector<std::string>& words) {
  bool first = true;
  for (const std::string& word : words) {
    if (word.empty()) continue;
    text += (first ? "" : " ") + word;
    first = false;
  }
  text += '\n';
  ++lines_;
}

void Drawing::test(const std::vector<std::string>& words) {
  put(words);
  test_line = lines_;
}

std::string Drawing::word(std::string_view address, std::string_view parameter) const {
  return pick_.is(parameter, "none") ? "" : word(address, pick_.length(parameter));
}

std::string Drawing::word(std::string_view address, Length value) const {
  return fmt::format("{}{}", address, value.text(decimals_));
}

std::string Drawing::travel(Role role, Length way) const {
  if (pick_.is("distance", "letters")) return letters(role, way);
  return target(std::string_view("XYZ").substr(axis(role), 1), role, way);
}

std::string Drawing::target(std::string_view address, Role role, Length way) const {
  const bool increment = pick_.is("distance", "modal") || pick_.is("distance", "IC");
  const Length value = increment ? way : at_[static_cast<std::size_t>(role)] + way;
  const std::string number = word("", scaled(role, value));
  if (pick_.is("distance", "IC")) return fmt::format("{}=IC({})", address, number);
  if (pick_.is("distance", "AC")) return fmt::format("{}=AC({})", address, number);
  return fmt::format("{}{}{}", address, address.size() > 1 ? "=" : "", number);
}

std::string Drawing::absolute(Role role, Length way) const {
  const Length to = at_[static_cast<std::size_t>(role)] + way;
  return word(std::string_view("XYZ").substr(axis(role), 1), scaled(role, to));
}

std::string Drawing::letters(Role role, Length way) const {
  return word(std::string_view("UVW").substr(axis(role), 1), scaled(role, way));
}

std::string Drawing::offset(Role role, Length way) const {
  return word(std::string_view("IJK").substr(axis(role), 1), way);
}

}  // namespace gonogo::cover
