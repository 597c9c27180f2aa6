#pragma once

#include <stdexcept>
#include <string>

namespace nearwall {

/// Base of all errors that nearwall throws. The message says what was expected, what was found, where, and what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The command line, the case file or an argument is wrong (exit code 2).
class InputError : public Error {
 public:
  using Error::Error;
};

/// The surface cannot be used (exit code 3).
class GeometryError : public Error {
 public:
  using Error::Error;
};

/// The machine: disk full, no permission, no memory (exit code 5).
class IoError : public Error {
 public:
  using Error::Error;
};

/// A library or program that nearwall calls failed in a part that was asked for (exit code 4).
class BackendError : public Error {
 public:
  using Error::Error;
};

/// The user asked to stop (exit code 130).
class Interrupted : public Error {
 public:
  Interrupted() : Error("interrupted") {}
};

/// A defect of nearwall itself (exit code 70).
class InternalError : public Error {
 public:
  using Error::Error;
};

}  // namespace nearwall
