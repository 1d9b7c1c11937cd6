# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause

# Every option of the build, with the compile flags that follow from them. The summary at the end
# of the configuration prints what is set here.

option(BUILD_SHARED_LIBS "Build shared libraries" ON)
option(BUILD_TESTING "Build the tests" ON)
option(VTKOIT_WERROR "Treat compiler warnings as errors" OFF)
option(VTKOIT_SANITIZE_ADDRESS "Compile and link with AddressSanitizer" OFF)
option(VTKOIT_BUILD_PARAVIEW "Build the plugin for ParaView, and all else for ParaView's VTK" OFF)
# VTKOIT_WRAP_PYTHON is in vtkOITDependencies.cmake: its default depends on the VTK found.

get_property(vtkoit_is_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT CMAKE_BUILD_TYPE AND NOT vtkoit_is_multi_config)
  set(CMAKE_BUILD_TYPE "Release" CACHE STRING "Build type" FORCE)
  set_property(CACHE CMAKE_BUILD_TYPE PROPERTY STRINGS Debug Release RelWithDebInfo MinSizeRel)
endif()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON) # for clang-tidy

if(BUILD_TESTING)
  enable_testing()
endif()

set(vtkoit_sanitizer_flags)
set(vtkoit_warning_flags)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(vtkoit_warning_flags -Wall -Wextra -Wshadow=local)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    set(vtkoit_warning_flags -Wall -Wextra -Wshadow)
  endif()
  if(VTKOIT_WERROR)
    list(APPEND vtkoit_warning_flags -Werror)
  endif()
elseif(VTKOIT_WERROR)
  message(WARNING "vtkOIT: VTKOIT_WERROR has no effect with the compiler "
    "${CMAKE_CXX_COMPILER_ID}; use GCC or Clang.")
endif()
add_compile_options(${vtkoit_warning_flags})

if(VTKOIT_SANITIZE_ADDRESS)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    message(FATAL_ERROR "vtkOIT: VTKOIT_SANITIZE_ADDRESS needs GCC or Clang, the compiler is "
      "${CMAKE_CXX_COMPILER_ID}; configure with -DCMAKE_CXX_COMPILER=g++ or switch it off.")
  endif()
  # GCC takes the redzones in std::regex for uninitialized members.
  set(vtkoit_sanitizer_flags -fsanitize=address -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    list(REMOVE_ITEM vtkoit_sanitizer_flags -Wno-maybe-uninitialized)
  endif()
  add_compile_options(${vtkoit_sanitizer_flags})
  add_link_options(-fsanitize=address)
endif()
