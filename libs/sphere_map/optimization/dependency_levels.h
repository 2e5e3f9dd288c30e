// Steps that each read some vertices and write some of them, grouped so that independent ones run side by side.
//
// Steps have an order. A step's dependency_level comes after those of all earlier steps that write what it reads or
// read what it writes, so running dependency_level after dependency_level, the steps of each in any order and on any
// threads, gives the same bits as running the steps one by one. Steps far from each other on the surface do not wait
// for each other: these are the independent regions that the dissertation names as future work.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/threads/thread_pool.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;

class DependencyLevels {
 public:
  // Calls that run at the same time have different slots, for scratch space of their own.
  static constexpr std::size_t slots = 32;

  DependencyLevels(std::size_t vertex_count, const base::Host& host, const base::ThreadPool& pool)
      : pool_(pool),
        last_write_(vertex_count, 0, host.memory),
        last_read_(vertex_count, 0, host.memory),
        wave_(host.memory),
        begin_(host.memory),
        order_(host.memory) {}

  // Adds the next step. What it writes it may read as well.
  template <class Writes, class Reads>
  void add(const Writes& writes, const Reads& reads) {
    std::uint32_t dependency_level = first_;
    for (const Index v : reads)
      dependency_level = std::max(dependency_level, last_write_[v] + 1);
    for (const Index v : writes)
      dependency_level = std::max({dependency_level, last_write_[v] + 1, last_read_[v] + 1});
    for (const Index v : reads)
      last_read_[v] = std::max(last_read_[v], dependency_level);
    for (const Index v : writes)
      last_write_[v] = dependency_level;
    wave_.push_back(dependency_level);
  }

  // Calls body(step, slot) for every step that was added, numbered from 0, and starts again: beside(done, total) is
  // called once a dependency_level, while one thread or another runs the dependency_level's steps, and may add steps of
  // the next run, the part done / total of them all; with the last dependency_level that part is the whole.
  template <class Body, class Beside>
  void run(const Body& body, const Beside& beside) {
    const std::size_t dependency_levels = sort();
    for (std::size_t w = 0; w < dependency_levels; ++w) {
      const std::span<const Index> steps(order_.data() + begin_[w], begin_[w + 1] - begin_[w]);
      const std::size_t pieces = std::clamp<std::size_t>(steps.size() / steps_a_piece, 1, slots);
      const auto run_piece = [&](std::size_t slot) {
        for (std::size_t i = slot * steps.size() / pieces; i < (slot + 1) * steps.size() / pieces; ++i)
          body(std::size_t{steps[i]}, slot);
      };
      const auto run_beside = [&] { beside(begin_[w + 1], order_.size()); };
      if (pieces == 1) {
        run_piece(0);
        run_beside();
      } else {
        pool_.run(pieces + 1, [&](std::size_t i) { i == 0 ? run_beside() : run_piece(i - 1); });
      }
    }
  }

  // Gives its memory back: no step can be added any more.
  void release();

 private:
  // Threads are not worth their while for less.
  static constexpr std::size_t steps_a_piece = 4;

  // Puts the steps into order_ by their dependency_levels, dependency_level w from begin_[w] on. Returns the number of
  // dependency_levels.
  std::size_t sort();

  const base::ThreadPool& pool_;
  std::uint32_t first_ = 1;  // dependency_level of the steps at hand that wait for none; earlier ones have run
  Array<std::uint32_t> last_write_, last_read_;  // latest dependency_levels that write or read a vertex
  Array<std::uint32_t> wave_;                    // of each step
  Array<std::size_t> begin_;
  Array<Index> order_;
};

}  // namespace orbicube::sphere_map
