#include "program/exit_codes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "nearwall/core/errors.h"
#include "nearwall/surface/admission.h"

namespace nearwall::program {
namespace {

template <class Error>
ExitCode code_of(const Error& error) {
  return explain(std::make_exception_ptr(error)).code;
}

TEST(Explain, MapsEachErrorToTheExitCodeOfTheContract) {
  EXPECT_EQ(code_of(InputError("")), ExitCode::BadInput);
  EXPECT_EQ(code_of(GeometryError("")), ExitCode::BadSurface);
  EXPECT_EQ(code_of(surface::SurfaceRejected("", {})), ExitCode::BadSurface);
  EXPECT_EQ(code_of(BackendError("")), ExitCode::PartMissing);
  EXPECT_EQ(code_of(IoError("")), ExitCode::Machine);
  EXPECT_EQ(code_of(std::bad_alloc()), ExitCode::Machine);
  EXPECT_EQ(code_of(std::filesystem::filesystem_error("", std::make_error_code(std::errc::permission_denied))),
            ExitCode::Machine);
  EXPECT_EQ(code_of(Interrupted()), ExitCode::Interrupted);
  EXPECT_EQ(code_of(InternalError("")), ExitCode::Defect);
  EXPECT_EQ(code_of(std::logic_error("")), ExitCode::Defect);
  EXPECT_EQ(code_of(42), ExitCode::Defect);
}

TEST(Explain, AsksToReportADefect) {
  const Failure failure = explain(std::make_exception_ptr(InternalError("a prism turned over")));
  EXPECT_NE(failure.message.find("a prism turned over"), std::string::npos);
  EXPECT_NE(failure.message.find("report"), std::string::npos);
}

}  // namespace
}  // namespace nearwall::program
