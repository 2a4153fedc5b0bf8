# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's cross compiler for arm64; packaging/release fetches the libraries into GONOGO_ARM64_ROOT.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES GONOGO_ARM64_ROOT)
# Headers of templates are the same on every machine, those of gmp are not.
set(CMAKE_CXX_FLAGS_INIT "-isystem ${GONOGO_ARM64_ROOT}/usr/include/aarch64-linux-gnu -isystem ${GONOGO_ARM64_ROOT}/usr/include")
set(CMAKE_C_FLAGS_INIT "${CMAKE_CXX_FLAGS_INIT}")
set(CMAKE_FIND_ROOT_PATH "${GONOGO_ARM64_ROOT}")
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
