#include "apps/command.hpp"
namespace scanchor::apps {
void add_score(CLI::App&, ExitCodeSlot&) {}
}
