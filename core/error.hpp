#pragma once
// Errors that a person caused and can mend. A broken invariant is not one of them: that is what
// assert is for.

#include <stdexcept>
#include <string>
#include <string_view>

namespace scanchor {

/// Exit codes of every `scanchor` verb (docs/reference/exit-codes.md).
enum class ExitCode : int {
  done = 0,
  gate_failed = 1,
  wrong_usage = 2,
  bad_data = 3,
  nothing_measured = 4,
  inconclusive = 5,
};

/// One clear line for the person, and the exit code that goes with it. Libraries throw it, the
/// command prints it.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& line) : std::runtime_error(line), code_(code) {}
  [[nodiscard]] ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Bad or mismatching data: "`file`:`place`: `cause`; `remedy`". Empty parts are left out.
/// `place` is what the format counts: "line 12", "byte 4096", "point 17".
[[noreturn]] void fail_data(std::string_view file, std::string_view place, std::string_view cause,
                            std::string_view remedy = {});

/// Wrong usage: an option, a value, a path that cannot be what was meant.
[[noreturn]] void fail_usage(std::string_view cause, std::string_view remedy = {});

}  // namespace scanchor
