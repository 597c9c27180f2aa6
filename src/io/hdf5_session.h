#pragma once

namespace nearwall::io {

/// Alone with HDF5, and with CGNS which lies on it, for as long as it lives: neither is safe on several threads in
/// every build, and CGNS has one last error for all files. HDF5 prints nothing meanwhile. May be nested in one thread.
/// Nothing is to run in parallel within: it might wait for itself.
class Hdf5Session {
 public:
  Hdf5Session();
  ~Hdf5Session();
  Hdf5Session(const Hdf5Session&) = delete;
  Hdf5Session& operator=(const Hdf5Session&) = delete;

 private:
  using Printer = int (*)(long, void*);
  Printer printer_ = nullptr;  // what printed errors before, and its argument
  void* argument_ = nullptr;
};

}  // namespace nearwall::io
