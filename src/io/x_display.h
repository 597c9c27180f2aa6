#pragma once

#include <sys/types.h>

#include <string>

namespace nearwall::io {

/// An X server of our own without a screen (Xvfb), alive as long as this object. It ends with this process, too,
/// however that ends.
class PrivateDisplay {
 public:
  PrivateDisplay();
  ~PrivateDisplay();
  PrivateDisplay(const PrivateDisplay&) = delete;
  PrivateDisplay& operator=(const PrivateDisplay&) = delete;

  bool works() const { return !name_.empty(); }
  const std::string& name() const { return name_; }      ///< for the environment variable DISPLAY, e.g. ":99"
  const std::string& reason() const { return reason_; }  ///< why it does not work

 private:
  std::string read_number(int from);

  pid_t pid_ = -1;
  std::string name_;
  std::string reason_;
};

}  // namespace nearwall::io
