#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace scanchor {
namespace {

TEST(Parallel, BlocksCoverEachIndexOnce) {
  for (const std::size_t count : {0U, 1U, 7U, 1000U, 1001U}) {
    for (const std::size_t block : {0U, 1U, 10U, 5000U}) {
      std::vector<std::atomic<int>> touched(count);
      parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        EXPECT_LT(begin, end);
        EXPECT_LE(end - begin, std::max<std::size_t>(block, 1));
        for (std::size_t i = begin; i < end; ++i) ++touched[i];
      });
      for (const auto& t : touched) EXPECT_EQ(t.load(), 1);
    }
  }
}

TEST(Parallel, BlockBordersDoNotDependOnThreads) {
  const auto borders = [](int threads) {
    const ThreadLimit limit(threads);
    std::vector<std::size_t> ends(1000);
    parallel_blocks(1000, 33, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ends[i] = end;
    });
    return ends;
  };
  EXPECT_EQ(borders(1), borders(2));
}

TEST(Parallel, OneThreadMeansOne) {
  const ThreadLimit limit(1);
  std::vector<std::thread::id> ids(64);
  parallel_blocks(64, 1,
                  [&](std::size_t begin, std::size_t) { ids[begin] = std::this_thread::get_id(); });
  EXPECT_EQ(std::set<std::thread::id>(ids.begin(), ids.end()).size(), 1U);
}

TEST(Parallel, AWaitingThreadDoesNotBeginAnotherOuterBlock) {
  const ThreadLimit limit(2);
  static thread_local int depth = 0;
  std::atomic<int> deepest = 0;
  parallel_blocks(200, 1, [&](std::size_t, std::size_t) {
    ++depth;
    int seen = deepest.load();
    while (depth > seen && !deepest.compare_exchange_weak(seen, depth)) {
    }
    parallel_blocks(50, 1, [&](std::size_t, std::size_t) {
      volatile double x = 1.0;
      for (int i = 0; i < 2000; ++i) x = x * 1.0000001;
    });
    --depth;
  });
  EXPECT_EQ(deepest.load(), 1);
}

TEST(Parallel, AnExceptionComesOut) {
  EXPECT_THROW(parallel_blocks(100, 1,
                               [](std::size_t begin, std::size_t) {
                                 if (begin == 50) throw std::runtime_error("x");
                               }),
               std::runtime_error);
}

}  // namespace
}  // namespace scanchor
