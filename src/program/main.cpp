#include <exception>

#include <nlohmann/json.hpp>

#include "nearwall/core/parallel.h"
#include "program/cli.h"
#include "program/interrupt.h"

namespace nearwall::program {
namespace {

ExitCode report_failure(Console& console, const Failure& failure) {
  console.fail(failure.message);
  const int code = static_cast<int>(failure.code);
  console.print_json(
      nlohmann::json{{"error", {{"kind", failure.kind}, {"exit_code", code}, {"message", failure.message}}}});
  return failure.code;
}

Invocation parse(int argc, const char* const* argv) {
  CommandLine line;
  add_run_command(line);
  add_batch_command(line);
  add_check_command(line);
  add_init_command(line);
  add_normals_command(line);
  add_layers_command(line);
  add_shape_command(line);
  add_picture_command(line);
  add_convert_command(line);
  add_certify_command(line);
  add_study_command(line);
  return line.parse(argc, argv);
}

ExitCode run_program(int argc, const char* const* argv) {
  Console console(manner_of(argc, argv));
  try {
    const Invocation invocation = parse(argc, argv);
    if (!invocation.command) {
      Console(Manner{}).print(invocation.text);
      return ExitCode::Done;
    }
    console = Console(invocation.manner);
    catch_interrupts();
    const ThreadLimit limit(invocation.n_threads);
    CommandContext context{console, invocation.n_threads};
    return invocation.command(context);
  } catch (...) {
    return report_failure(console, explain(std::current_exception()));
  }
}

}  // namespace
}  // namespace nearwall::program

int main(int argc, char** argv) {
  try {
    return static_cast<int>(nearwall::program::run_program(argc, argv));
  } catch (...) {
    // Standard output takes no more, and that was being told on it.
    return static_cast<int>(nearwall::program::ExitCode::Machine);
  }
}
