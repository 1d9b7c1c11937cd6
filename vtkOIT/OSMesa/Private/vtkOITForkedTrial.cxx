// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/vtkOITForkedTrial.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace
{
// A child of a process with several threads may wait for ever for a lock that one of them held.
constexpr int LongestWait = 30000; // milliseconds

//------------------------------------------------------------------------------
// In the child: the outcome goes into the pipe, success as an empty line.
[[noreturn]] void Report(int pipe, const std::function<std::string()>& trial) noexcept
{
  const std::string text = trial() + '\n';
  const char* rest = text.data();
  for (size_t left = text.size(); left > 0;)
  {
    const ssize_t written = write(pipe, rest, left);
    if (written < 0 && errno != EINTR)
    {
      break;
    }
    if (written > 0)
    {
      rest += written;
      left -= static_cast<size_t>(written);
    }
  }
  _exit(0);
}

//------------------------------------------------------------------------------
// In the parent: the line that comes out of the pipe. False when that takes too long.
bool ReadLine(int pipe, std::string& text)
{
  while (text.empty() || text.back() != '\n')
  {
    pollfd wanted = { pipe, POLLIN, 0 };
    const int ready = poll(&wanted, 1, LongestWait);
    if (ready == 0)
    {
      return false;
    }
    char buffer[512];
    const ssize_t size = ready > 0 ? read(pipe, buffer, sizeof(buffer)) : -1;
    if (size == 0 || (size < 0 && errno != EINTR))
    {
      return true;
    }
    if (size > 0)
    {
      text.append(buffer, static_cast<size_t>(size));
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
std::string vtkOITTryInChild(const std::function<std::string()>& trial)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    return trial();
  }
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    Report(ends[1], trial);
  }
  close(ends[1]);
  std::string text;
  const bool done = child > 0 && ReadLine(ends[0], text);
  close(ends[0]);
  if (child < 0)
  {
    return trial();
  }
  if (!done)
  {
    // Not known: the first window will tell.
    kill(child, SIGKILL);
    text = "\n";
  }
  while (waitpid(child, nullptr, 0) < 0 && errno == EINTR)
  {
  }
  if (text.empty() || text.back() != '\n')
  {
    return "a process that was to try it crashed";
  }
  text.pop_back(); // the line's end
  return text;
}
