#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "program/console.h"
#include "program/exit_codes.h"

namespace nearwall::program {

/// What a command is given to work with.
struct CommandContext {
  Console& console;
  int n_threads = 0;  ///< 0: as many as the machine has
};

using Command = std::function<ExitCode(CommandContext&)>;

/// What the command line asks for.
struct Invocation {
  Manner manner;
  int n_threads = 0;
  Command command;   ///< empty if only `text` is wanted
  std::string text;  ///< help or version, for standard output
};

/// All commands with their options. Commands add themselves once; `parse` is called once.
class CommandLine {
 public:
  CommandLine();

  /// A command with the options that all have in common.
  /// \param usage    arguments and the options worth knowing, such as "CASE.toml [-o DIR]"
  /// \param example  whole command lines, one a line
  /// \param command  called after parsing; whatever it captures must outlive the command line
  CLI::App& add(const std::string& name, const std::string& summary, const std::string& usage,
                const std::string& example, Command command);
  /// The same below another command, as `nearwall shape sphere`.
  CLI::App& add_below(CLI::App& parent, const std::string& name, const std::string& summary, const std::string& usage,
                      const std::string& example, Command command);

  /// \throws InputError naming what is wrong and the nearest valid word
  Invocation parse(int argc, const char* const* argv);

 private:
  CLI::App app_;
  Invocation invocation_;
  bool wants_version_ = false;
};

/// Refuses all but finite numbers of at least 0, in words that name neither the largest double nor its 309 digits.
CLI::Validator non_negative();

// Each in its own file, NAME_command.cpp.
void add_run_command(CommandLine& line);
void add_batch_command(CommandLine& line);
void add_check_command(CommandLine& line);
void add_init_command(CommandLine& line);
void add_normals_command(CommandLine& line);
void add_layers_command(CommandLine& line);
void add_shape_command(CommandLine& line);
void add_picture_command(CommandLine& line);
void add_convert_command(CommandLine& line);
void add_certify_command(CommandLine& line);
void add_study_command(CommandLine& line);

/// Manner as far as it can be told from a command line that does not parse.
Manner manner_of(int argc, const char* const* argv);

}  // namespace nearwall::program
