#include <algorithm>

#include "nearwall/surface/point_normals.h"

namespace nearwall::surface {

std::string_view method_name(NormalMethod method) { return kNormalMethodNames[static_cast<std::size_t>(method)]; }

std::optional<NormalMethod> normal_method(std::string_view name) {
  const auto at = std::find(kNormalMethodNames.begin(), kNormalMethodNames.end(), name);
  if (at == kNormalMethodNames.end()) return std::nullopt;
  return static_cast<NormalMethod>(at - kNormalMethodNames.begin());
}

std::optional<Weight> weight_of(NormalMethod method) {
  switch (method) {
    case NormalMethod::Uniform:
      return Weight::Uniform;
    case NormalMethod::Area:
      return Weight::Area;
    case NormalMethod::InverseArea:
      return Weight::InverseArea;
    case NormalMethod::ProjectedArea:
      return Weight::ProjectedArea;
    case NormalMethod::Angle:
      return Weight::Angle;
    case NormalMethod::InverseRootEdges:
      return Weight::InverseRootEdges;
    case NormalMethod::InverseEdges:
      return Weight::InverseEdges;
    case NormalMethod::InverseSquaredEdges:
      return Weight::InverseSquaredEdges;
    case NormalMethod::Max:
      return Weight::Max;
    case NormalMethod::LittleMax:
      return Weight::LittleMax;
    case NormalMethod::InverseDiameter:
      return Weight::InverseDiameter;
    case NormalMethod::AngleOverDiameter:
      return Weight::AngleOverDiameter;
    case NormalMethod::InverseCircumArea:
      return Weight::InverseCircumArea;
    case NormalMethod::AngleOverCircumArea:
      return Weight::AngleOverCircumArea;
    default:
      return std::nullopt;
  }
}

std::optional<Fit> fit_of(NormalMethod method) {
  switch (method) {
    case NormalMethod::LinearFit:
      return Fit::LinearLeastSquares;
    case NormalMethod::QuadraticFit:
      return Fit::QuadraticLeastSquares;
    case NormalMethod::RenkaCline:
      return Fit::RenkaCline;
    case NormalMethod::Shepard:
      return Fit::Shepard;
    case NormalMethod::Hardy:
      return Fit::Hardy;
    case NormalMethod::ThinPlate:
      return Fit::ThinPlate;
    default:
      return std::nullopt;
  }
}

}  // namespace nearwall::surface
