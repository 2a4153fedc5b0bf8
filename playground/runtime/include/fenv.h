// SPDX-License-Identifier: GPL-3.0-or-later
//
// WebAssembly rounds to nearest alone. CGAL's intervals name the other modes; exact numbers use none of them.
#pragma once

#include_next <fenv.h>

#ifndef FE_UPWARD
#define FE_UPWARD 1
#define FE_DOWNWARD 2
#define FE_TOWARDZERO 3
#endif
