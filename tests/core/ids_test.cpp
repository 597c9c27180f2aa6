#include "nearwall/core/ids.h"

#include <type_traits>

#include <gtest/gtest.h>

#include "nearwall/core/id_vector.h"

namespace nearwall {
namespace {

template <class Container, class Index>
concept IndexableBy = requires(Container c, Index i) {
  c[i];
};

TEST(Id, IsInvalidUntilGivenAnIndex) {
  EXPECT_FALSE(VertexId().is_valid());
  EXPECT_TRUE(VertexId(0).is_valid());
}

TEST(IdVector, RefusesTheIndexOfSomethingElse) {
  static_assert(IndexableBy<IdVector<VertexId, int>, VertexId>);
  static_assert(!IndexableBy<IdVector<VertexId, int>, FaceId>);
  static_assert(!IndexableBy<IdVector<VertexId, int>, int>);
  static_assert(!std::is_convertible_v<VertexId, FaceId>);
}

TEST(IdVector, NumbersWhatIsPushed) {
  IdVector<VertexId, int> v;
  EXPECT_EQ(v.push_back(5), VertexId(0));
  EXPECT_EQ(v.push_back(6), VertexId(1));
  int n = 0;
  for (const VertexId id : v.ids()) n += v[id];
  EXPECT_EQ(n, 11);
}

}  // namespace
}  // namespace nearwall
