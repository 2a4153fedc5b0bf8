// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact number as a number type of CGAL.
#pragma once

#include <CGAL/number_type_basic.h>

#include <ostream>

#include "reference/exact/number.hpp"

namespace gonogo::exact {

// CGAL prints what it is made of.
inline std::ostream& operator<<(std::ostream& out, const Number& value) {
  return out << value.text();
}

}  // namespace gonogo::exact

// No operation rounds: no filter, no rounding mode. A sign that 4096 bits do not show throws
// exact::Undecided out of CGAL's predicates as out of the number's own comparisons.
template <>
struct CGAL::Algebraic_structure_traits<gonogo::exact::Number>
    : CGAL::Algebraic_structure_traits_base<gonogo::exact::Number, CGAL::Field_tag> {
  using Is_exact = CGAL::Tag_true;
  using Is_numerical_sensitive = CGAL::Tag_false;
};

template <>
struct CGAL::Real_embeddable_traits<gonogo::exact::Number>
    : CGAL::INTERN_RET::Real_embeddable_traits_base<gonogo::exact::Number, CGAL::Tag_true> {
  // One comparison each, where CGAL's own take two.
  struct Sgn : CGAL::cpp98::unary_function<Type, CGAL::Sign> {
    CGAL::Sign operator()(const Type& value) const { return CGAL::Sign(value.sign()); }
  };
  struct Compare : CGAL::cpp98::binary_function<Type, Type, CGAL::Comparison_result> {
    CGAL::Comparison_result operator()(const Type& a, const Type& b) const {
      return CGAL::Comparison_result(Type::compare(a, b));
    }
  };
};
