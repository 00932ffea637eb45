# Libraries of simcore and roversim; included at the top so that every folder sees the targets.
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(muparser REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(ODE REQUIRED IMPORTED_TARGET ode)
find_package(CLI11 REQUIRED)
