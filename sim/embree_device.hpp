#pragma once
// The device that Embree works on, and the mode of the processor that it wants. Private to
// sim/world.cpp.

#include <map>
#include <mutex>
#include <string>

#include "core/error.hpp"
#include "sim/embree_compat.hpp"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace scanchor {

/// Flush-to-zero and denormals-are-zero while it lives: Embree asks for both in every thread that
/// traces, and the caller's mode comes back afterwards.
class FlushDenormals {
 public:
#if defined(__SSE__)
  FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040U); }
  ~FlushDenormals() { _mm_setcsr(saved_); }

 private:
  unsigned int saved_;
#else
  FlushDenormals() {}
  ~FlushDenormals() {}

 public:
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;
};

/// One Embree device an instruction set, kept for the life of the program: making one costs more
/// than building a room.
inline RTCDevice device(const std::string& isa) {
  static std::mutex mutex;
  static auto& devices = *new std::map<std::string, RTCDevice>;
  const std::lock_guard lock(mutex);
  auto [place, fresh] = devices.try_emplace(isa, nullptr);
  if (fresh) {
    const std::string config = isa.empty() ? "" : "isa=" + isa;
    place->second = rtcNewDevice(config.empty() ? nullptr : config.c_str());
  }
  if (place->second == nullptr) {
    fail_usage("Embree cannot start with instruction set '" + isa + "'",
               "known are: sse2, sse4.2, avx, avx2, avx512");
  }
  return place->second;
}

}  // namespace scanchor
