#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace nearwall::io {

/// Damages files, in the same way at each run.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutated(std::string bytes) {
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  void change(std::string& bytes) {
    static const std::vector<std::string> kNasty = {
        "-1", "4294967296", "99999999999999999999", "nan", "1e999", "0", "\n", "\r", "\"", "<", "\xff\xff\xff\xff"};
    const std::size_t at = below(bytes.size());
    switch (below(6)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes[at] = static_cast<char>(random_());
        break;
      case 2:
        bytes.erase(at, 1 + below(20));
        break;
      case 3:
        bytes.insert(at, kNasty[below(kNasty.size())]);
        break;
      case 4:
        bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), kNasty[below(kNasty.size())]);
        break;
      default:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(60)));
        break;
    }
  }

  std::mt19937 random_;
};

}  // namespace nearwall::io
