#pragma once

#include <cstdint>

#include "simcore/base/random.h"
#include "simcore/statics/quasi_convex.h"

namespace testsupport {

inline Eigen::MatrixXd randomMatrix(simcore::Random& random, Eigen::Index rows, Eigen::Index cols) {
    return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return random.uniform(-1.0, 1.0); });
}

inline void addCone(simcore::statics::QuasiConvexProgram& program, const Eigen::MatrixXd& rows,
                    const Eigen::VectorXd& offsets, const Eigen::VectorXd& slope, double start) {
    simcore::statics::Cone& cone = program.addCone(rows.rows());
    cone.rows = rows;
    cone.offsets = offsets;
    cone.slope = slope;
    cone.start = start;
}

inline void addHalfSpace(simcore::statics::QuasiConvexProgram& program,
                         const Eigen::VectorXd& slope, double start) {
    simcore::statics::HalfSpace& half = program.addHalfSpace();
    half.slope = slope;
    half.start = start;
}

/// Cones of the kind that contacts make, in a box of y.
inline simcore::statics::QuasiConvexProgram randomProgram(simcore::Scratch& room, int seed,
                                                          Eigen::Index n, int cones,
                                                          Eigen::Index size, double box = 2.0) {
    simcore::Random random(static_cast<std::uint64_t>(seed));
    simcore::statics::QuasiConvexProgram program(room, n, static_cast<std::size_t>(cones),
                                                 static_cast<std::size_t>(cones + 2 * n));
    for (int i = 0; i < cones; ++i) {
        const Eigen::MatrixXd rows = randomMatrix(random, size, n);
        const Eigen::VectorXd offsets = 3.0 * randomMatrix(random, size, 1);
        const Eigen::VectorXd slope = randomMatrix(random, n, 1);
        const double start = random.uniform(0.5, 2.0);
        addHalfSpace(program, slope, start);
        addCone(program, rows, offsets, slope, start);
    }
    for (Eigen::Index k = 0; k < n; ++k) {
        addHalfSpace(program, Eigen::VectorXd::Unit(n, k), box);
        addHalfSpace(program, -Eigen::VectorXd::Unit(n, k), box);
    }
    return program;
}

}  // namespace testsupport
