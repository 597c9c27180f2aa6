#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "nearwall/layers/grow.h"
#include "nearwall/pipeline/case.h"
#include "pipeline/prepare.h"

namespace nearwall::sweep {

/// S: 20 layers, 1 % of the diagonal of the bounding box thick in all. R: 30 layers from a millionth of it on.
/// Both grow by 1.2.
enum class Standard { S, R };
inline constexpr std::array<const char*, 2> kStandardNames = {"S", "R"};

/// What one growth came to. Shares are of the wall's area [percent].
struct Row {
  bool is_certified = false;
  double all = 0;             ///< with all layers
  double full = 0;            ///< with all layers and the full thickness
  double any = 0;             ///< with any layer
  double first = 0;           ///< with a first height within 5 % of the asked one
  double large_first = 0;     ///< with one above 1.5 times the asked one, where no line starts late
  double mean_layers = 0;     ///< by area
  double largest_growth = 0;  ///< upper over lower height of successive layers, the largest of all lines
  int n_reasons = 0;          ///< different reasons of limited triangles
  std::string limits;         ///< the largest of them with their shares
  Vec3 worst_place;           ///< the largest of the triangles with the largest reason
  Vec3 worst_normal;          ///< of the wall there
  double diagonal = 0;        ///< of the surface's bounding box [length]
  double lines = 0;           ///< for a vertex
  double rounds = 0;
  double seconds = 0;  ///< of growing
};

/// A surface that was admitted, or why not.
struct Sample {
  std::filesystem::path file;
  std::string name;
  std::string refusal;  ///< in short; empty for a surface that can be used
  std::size_t n_triangles = 0;
};

/// Changes options before growing: a lever switched off.
using Change = std::function<void(layers::GrowOptions&)>;

/// A surface in memory, ready to be grown on as often as is wanted.
class Body {
 public:
  /// \param overrides  "key=value" of a case file \throws Error as pipeline::prepare
  Body(const std::filesystem::path& file, const std::vector<std::string>& overrides);
  std::size_t n_triangles() const { return prepared_.surface().faces.size(); }
  Row grow(Standard standard, const Change& change) const;

 private:
  Case settings_;
  pipeline::Prepared prepared_;
};

/// "56 open edges" of the message of an error.
std::string short_refusal(const std::string& message, const std::filesystem::path& file);

}  // namespace nearwall::sweep
