#include "core/error.hpp"

namespace scanchor {

void fail_data(std::string_view file, std::string_view place, std::string_view cause,
               std::string_view remedy) {
  std::string line(file);
  if (!place.empty()) line += (line.empty() ? "" : ": ") + std::string(place);
  if (!line.empty()) line += ": ";
  line += cause;
  if (!remedy.empty()) line += "; " + std::string(remedy);
  throw Error(ExitCode::bad_data, line);
}

void fail_usage(std::string_view cause, std::string_view remedy) {
  std::string line(cause);
  if (!remedy.empty()) line += "; " + std::string(remedy);
  throw Error(ExitCode::wrong_usage, line);
}

}  // namespace scanchor
