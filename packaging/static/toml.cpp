// SPDX-License-Identifier: GPL-3.0-or-later
//
// toml++ as a static library, from its installed headers.
#include <toml++/toml.h>
