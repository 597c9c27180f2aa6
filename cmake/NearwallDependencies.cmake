# Third-party packages, all from Debian (cmake/debian-packages.txt).
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
set(NEARWALL_VTK_COMPONENTS
    CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersGeneral FiltersGeometry FiltersExtraction
    FiltersSources IOCore IOGeometry IOImage IOLegacy IOPLY IOXML RenderingAnnotation RenderingCore
    RenderingFreeType RenderingOpenGL2)
find_package(Threads REQUIRED)
find_package(CGAL 5.5 REQUIRED)
find_package(VTK 9.1 REQUIRED COMPONENTS ${NEARWALL_VTK_COMPONENTS})
find_package(TBB 2021 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(tomlplusplus 3 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
# VTK and CGAL bring find modules of their own, which make no target.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(ZLIB REQUIRED)
find_package(TetGen REQUIRED)
find_package(CGNS REQUIRED)
# The serial library, as CGNS has it; VTK is built with the parallel one, which no target of nearwall links.
find_package(HDF5 1.10 REQUIRED COMPONENTS C)
