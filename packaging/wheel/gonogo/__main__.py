# SPDX-License-Identifier: GPL-3.0-or-later
from gonogo import main

main()
