// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The parts of an A-buffer's pool for regions of the screen, without OpenGL: their sizes, and that threads
// which take pages from them get each page once and share no counter.
//
//   vtkOITCxxTests TestNodeRegions --threads    also prints what a page costs, by number of threads

#include "Rig/Report.h"
#include "Rig/Setup.h"

#include "Private/ABuffer/vtkOITNodeRegions.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <iostream>
#include <memory>
#include <numeric>
#include <thread>

using namespace vtkOITTest;

namespace
{
vtkOITRectangle MakeRectangle(int x, int y, int width, int height)
{
  vtkOITRectangle r;
  r.X = x;
  r.Y = y;
  r.Width = width;
  r.Height = height;
  return r;
}

/// As many fragments in each tile, or none.
void Update(vtkOITNodeRegions& regions, const vtkOITRectangle& rectangle, std::uint32_t fragments,
  int frames = 1)
{
  const vtkOITTileGrid tiles(rectangle);
  const std::vector<std::uint32_t> each(tiles.GetNumberOfTiles(), fragments);
  for (int i = 0; i < frames; ++i)
  {
    regions.Update(tiles, each);
  }
}

std::int64_t GetSize(const vtkOITNodeRegions::Region& region)
{
  return std::int64_t{ region.End } - region.Begin;
}

void CheckSizes(Report& report)
{
  const vtkOITRectangle whole = MakeRectangle(0, 0, 256, 128);
  constexpr std::int64_t nodes = 1 << 20;
  vtkOITNodeRegions regions;
  report.Check(!regions.Plan(whole, nodes), "regions of a frame of which nothing is known");
  Update(regions, whole, 512); // two layers
  report.Check(!regions.Plan(whole, nodes), "regions in the second frame");
  Update(regions, whole, 512);
  report.Check(regions.Plan(whole, nodes), "no regions in the third frame");
  report.Check(regions.GetRegions().size() == 8, "not eight regions");
  // 8192 fragments and a quarter of that, and three nodes for each of 4096 pixels.
  std::int64_t end = OIT_PAGE_SIZE;
  for (const vtkOITNodeRegions::Region& region : regions.GetRegions())
  {
    report.Check(region.Begin == end, "a region does not begin where the one before ends");
    report.Check(GetSize(region) == 8192 + 2048 + 3 * 4096,
      "a region has " + std::to_string(GetSize(region)) + " nodes");
    end = region.End;
  }
  report.Check(regions.FindNodes(whole) == 0, "memory is asked for after two frames");
  Update(regions, whole, 512, 6);
  report.Check(regions.FindNodes(whole) == end, "other memory is asked for than planned");

  // Kept while they are large enough, and not where there is less room.
  Update(regions, whole, 576);
  report.Check(regions.Plan(whole, nodes) && GetSize(regions.GetRegions()[0]) == 22528,
    "regions were made anew for an eighth more");
  Update(regions, whole, 1024);
  report.Check(
    regions.Plan(whole, nodes) && GetSize(regions.GetRegions()[0]) == 16384 + 4096 + 12288,
    "regions are too small");
  report.Check(!regions.Plan(whole, 8 * 32768), "regions in a pool that is too small");
  report.Check(
    regions.Plan(whole, 8 * 32768 + 4), "no regions in a pool that is just large enough");

  // A rectangle off the regions' borders, with pixels in 2 x 2 of them.
  const vtkOITRectangle part = MakeRectangle(60, 60, 8, 8);
  report.Check(regions.Plan(part, nodes) && regions.GetRegions().size() == 4, "not four regions");
  report.Check(
    regions.GetGrid().FirstColumn == 0 && regions.GetGrid().Columns == 2, "other columns");

  // None for a while after one was exceeded, longer each time.
  regions.NoteExceeded();
  Update(regions, whole, 512, 7);
  report.Check(!regions.Plan(whole, nodes), "regions soon after one was exceeded");
  Update(regions, whole, 512);
  report.Check(regions.Plan(whole, nodes), "no regions any more");
  regions.NoteExceeded();
  Update(regions, whole, 512, 15);
  report.Check(!regions.Plan(whole, nodes), "the second pause is not longer");
}

/// A counter on a cache line of its own.
struct alignas(64) Counter
{
  std::atomic<std::uint32_t> Next{ 0 };
};

/// What Gather does: threads take regions one after the other, and in each a page for every pixel and layer.
struct Allocation
{
  static constexpr int PagesPerRegion = 64 * 64 * 2;
  const int Count;
  std::vector<vtkOITNodeRegions::Region> Regions; // empty: one counter for all
  std::unique_ptr<Counter[]> Counters;
  std::atomic<int> NextRegion{ 0 };
  std::vector<std::uint32_t> Pages; // that were given out, by region

  Allocation(int count, bool isShared)
    : Count(count)
    , Counters(std::make_unique<Counter[]>(count))
    , Pages(static_cast<std::size_t>(count) * PagesPerRegion)
  {
    if (isShared)
    {
      this->Counters[0].Next = OIT_PAGE_SIZE;
      return;
    }
    vtkOITNodeRegions regions;
    const vtkOITRectangle whole = MakeRectangle(0, 0, 64 * count, 64);
    Update(regions, whole, 256 * 8, 2);
    regions.Plan(whole, INT64_C(1) << 31);
    this->Regions = regions.GetRegions();
    for (int i = 0; i < count; ++i)
    {
      this->Counters[i].Next = this->Regions[i].Begin;
    }
  }

  void Work()
  {
    for (int region = this->NextRegion++; region < this->Count; region = this->NextRegion++)
    {
      Counter& counter = this->Counters[this->Regions.empty() ? 0 : region];
      std::uint32_t* page = &this->Pages[static_cast<std::size_t>(region) * PagesPerRegion];
      for (int i = 0; i < PagesPerRegion; ++i)
      {
        page[i] = counter.Next.fetch_add(OIT_PAGE_SIZE);
      }
    }
  }

  /// Nanoseconds.
  double Run(int threads)
  {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::thread> pool;
    for (int i = 0; i < threads; ++i)
    {
      pool.emplace_back([this] { this->Work(); });
    }
    for (std::thread& thread : pool)
    {
      thread.join();
    }
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start)
      .count();
  }
};

void CheckThreads(Report& report, int threads)
{
  Allocation shared(48, true);
  Allocation apart(48, false);
  shared.Run(threads);
  apart.Run(threads);
  const std::string what = std::to_string(threads) + " threads: ";
  report.Check(shared.Counters[0].Next == OIT_PAGE_SIZE * (1 + shared.Pages.size()),
    what + "other operations on the shared counter than pages");
  for (int i = 0; i < 48; ++i)
  {
    report.Check(
      apart.Counters[i].Next - apart.Regions[i].Begin == 4 * Allocation::PagesPerRegion &&
        apart.Counters[i].Next <= apart.Regions[i].End,
      what + "a region was exceeded");
  }
  for (Allocation* each : { &shared, &apart })
  {
    std::sort(each->Pages.begin(), each->Pages.end());
    report.Check(std::adjacent_find(each->Pages.begin(), each->Pages.end()) == each->Pages.end(),
      what + "a page was given out twice");
  }
}

/// Medians of 7 runs of 200 regions, as many as 800 x 800 pixels have.
void PrintTimes()
{
  std::cout << "ns a page of one frame, on " << std::thread::hardware_concurrency() << " cores\n"
            << "threads   one counter   a counter a region\n";
  for (const int threads : { 1, 2, 4, 8, 16, 32 })
  {
    std::array<std::vector<double>, 2> times;
    for (int round = 0; round < 7; ++round)
    {
      for (int kind = 0; kind < 2; ++kind)
      {
        Allocation allocation(200, kind == 0);
        times[kind].push_back(
          allocation.Run(threads) / static_cast<double>(allocation.Pages.size()));
      }
    }
    std::cout << threads;
    for (std::vector<double>& each : times)
    {
      std::nth_element(each.begin(), each.begin() + 3, each.end());
      std::cout << "   " << each[3];
    }
    std::cout << "\n";
  }
}
}

int TestNodeRegions(int argc, char* argv[])
{
  Report report;
  report.SetContext("regions of nodes");
  CheckSizes(report);
  for (const int threads : { 1, 2, 8, 16, 32 })
  {
    CheckThreads(report, threads);
  }
  if (argc > 1 && std::string(argv[1]) == "--threads")
  {
    PrintTimes();
  }
  return report.GetExitStatus();
}
