#include "nearwall/core/errors.h"
#include "program/cli.h"

namespace nearwall::program {

void add_certify_command(CommandLine& line) {
  CLI::App& app =
      line.add("certify", "the certificate of any mesh (not in this version)", "certify MESH.vtu [--wall SURFACE]",
               "nearwall certify out/onera-m6.vtu --wall onera_m6.stl", [](CommandContext&) -> ExitCode {
                 throw InputError(
                     "certify is not in this version.\nMeshes of `nearwall run` are certified before they "
                     "are written; report.json says so under \"certified\".");
               });
  app.allow_extras();
}

}  // namespace nearwall::program
