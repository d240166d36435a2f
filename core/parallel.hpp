#pragma once
// Threads, behind one door: TBB's headers stay in parallel.cpp.

#include <cstddef>
#include <functional>

namespace scanchor {

/// Calls body(begin, end) for disjoint blocks that cover [0, count). Which thread takes which block
/// is free, so a body must write only to places that its own indices name; then the result does not
/// depend on the number of threads.
void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

/// While it lives, at most `threads` threads work (0: as many as there are cores).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

}  // namespace scanchor
