# SPDX-License-Identifier: GPL-3.0-or-later
#
# Toolchain of the playground: Debian's clang-19 for WebAssembly, with its C and C++ libraries.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
find_program(CMAKE_AR llvm-ar-19 REQUIRED)
find_program(CMAKE_RANLIB llvm-ranlib-19 REQUIRED)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# Debian's headers of libraries that are headers alone lie where its own are.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
