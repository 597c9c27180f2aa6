#pragma once

namespace nearwall::program {

/// From now on SIGINT and SIGTERM ask for a clean stop; a second one of the same kind kills.
void catch_interrupts();

/// Whether a stop has been asked for.
bool is_interrupted();

/// \throws Interrupted if a stop has been asked for
void stop_if_interrupted();

}  // namespace nearwall::program
