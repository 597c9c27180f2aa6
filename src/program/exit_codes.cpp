#include "program/exit_codes.h"

#include <new>
#include <system_error>

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::program {

std::string kind_of(ExitCode code) {
  switch (code) {
    case ExitCode::Done:
      return "done";
    case ExitCode::Fault:
      return "fault";
    case ExitCode::BadInput:
      return "input";
    case ExitCode::BadSurface:
      return "surface";
    case ExitCode::PartMissing:
      return "part-missing";
    case ExitCode::Machine:
      return "machine";
    case ExitCode::Defect:
      return "defect";
    case ExitCode::Interrupted:
      return "interrupted";
  }
  return "defect";
}

namespace {

Failure failure(ExitCode code, std::string message) { return {code, kind_of(code), std::move(message)}; }

Failure defect(const std::string& what) {
  return failure(ExitCode::Defect,
                 fmt::format("{}\nThis is a defect of nearwall, not of your input. Please report it with the command "
                             "line, the case file and the surface.",
                             what));
}

}  // namespace

Failure explain(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const Interrupted&) {
    return failure(ExitCode::Interrupted, "interrupted; nothing unfinished was left behind");
  } catch (const InputError& e) {
    return failure(ExitCode::BadInput, e.what());
  } catch (const GeometryError& e) {
    return failure(ExitCode::BadSurface, e.what());
  } catch (const BackendError& e) {
    return failure(ExitCode::PartMissing, e.what());
  } catch (const IoError& e) {
    return failure(ExitCode::Machine, e.what());
  } catch (const std::bad_alloc&) {
    return failure(ExitCode::Machine,
                   "out of memory. `nearwall run CASE.toml --dry-run` forecasts what a case needs; fewer layers, a "
                   "coarser surface or a larger machine help");
  } catch (const std::system_error& e) {
    return failure(ExitCode::Machine, e.what());
  } catch (const std::exception& e) {
    return defect(e.what());
  } catch (...) {
    return defect("an exception of unknown type");
  }
}

}  // namespace nearwall::program
