// SPDX-License-Identifier: GPL-3.0-or-later
//
// fmt as a static library, from its installed headers: without FMT_HEADER_ONLY they define what the
// shared library has, except the templates that it makes in advance.
#include <fmt/format-inl.h>

namespace fmt::detail {

template dragonbox::decimal_fp<float> dragonbox::to_decimal(float) noexcept;
template dragonbox::decimal_fp<double> dragonbox::to_decimal(double) noexcept;
template thousands_sep_result<char> thousands_sep_impl(locale_ref);
template char decimal_point_impl(locale_ref);

}  // namespace fmt::detail
