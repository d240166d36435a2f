#pragma once
// Runs the built command as a person would and keeps what it said.

#include <string>

namespace scanchor::testing_support {

struct Ran {
  int code = -1;      ///< exit code; 128 + signal when it was killed
  std::string out;    ///< standard output
  std::string error;  ///< standard error
};

/// Arguments as the shell reads them. `input`-less, in a scratch folder that lives as long as the
/// test program.
Ran run_scanchor(const std::string& arguments);
/// The scratch folder, ending in '/'.
const std::string& scratch();
/// Number of lines of a text.
int lines_of(const std::string& text);

}  // namespace scanchor::testing_support
