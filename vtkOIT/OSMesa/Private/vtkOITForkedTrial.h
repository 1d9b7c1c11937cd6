// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tries something in a child process, so that this process stays as it was.
 *
 * Mesa starts threads for its first context. They do not come along when the process is forked
 * later (by Python's multiprocessing), and a process that has forked could not draw any more, if a
 * context had been made only to see whether that works.
 */

#ifndef vtkOITForkedTrial_h
#define vtkOITForkedTrial_h

#include <functional>
#include <string>

/**
 * What `trial` returns in a child process: empty when it succeeded, otherwise one line that names
 * the reason. Runs it in this process where no other can be made. A child that crashes has failed.
 */
std::string vtkOITTryInChild(const std::function<std::string()>& trial);

#endif
