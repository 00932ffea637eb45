#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "simcore/base/scratch.h"

namespace simcore::statics {

/// |rows y + offsets| <= s (slope y + start): s is to become small.
struct Cone {
    Scratch::Matrix rows{nullptr, 0, 0};
    Scratch::Vector offsets{nullptr, 0};
    Scratch::Vector slope{nullptr, 0};
    double start = 0.0;

    Scratch::Vector vector(Scratch& room, const Eigen::Ref<const Eigen::VectorXd>& y) const {
        Scratch::Vector result = room.vector(offsets);
        result.noalias() += rows.lazyProduct(y);
        return result;
    }

    double length(const Eigen::Ref<const Eigen::VectorXd>& y) const {
        return (rows.lazyProduct(y) + offsets).norm();
    }

    double reach(const Eigen::Ref<const Eigen::VectorXd>& y) const { return slope.dot(y) + start; }
};

/// slope y + start >= 0.
struct HalfSpace {
    Scratch::Vector slope{nullptr, 0};
    double start = 0.0;

    double room(const Eigen::Ref<const Eigen::VectorXd>& y) const { return slope.dot(y) + start; }
};

/// Minimise s over y within all half-spaces: a quasi-convex problem, whose every local minimum is
/// the minimum. Numbers of the order of 1, a handful of them.
class QuasiConvexProgram {
  public:
    /// Of so many cones and half-spaces at most, for as long as `room` gives.
    QuasiConvexProgram(Scratch& room, Eigen::Index unknowns, std::size_t cones,
                       std::size_t halfSpaces);

    Eigen::Index unknowns() const { return unknowns_; }

    std::span<const Cone> cones() const { return cones_.first(coneCount_); }

    std::span<const HalfSpace> halfSpaces() const { return halfSpaces_.first(halfSpaceCount_); }

    /// All zeros, to be filled in.
    Cone& addCone(Eigen::Index rows);
    HalfSpace& addHalfSpace();

    /// The least s that y is allowed with; infinite where a cone reaches nothing.
    double reached(const Eigen::Ref<const Eigen::VectorXd>& y) const;

  private:
    Scratch& room_;
    Eigen::Index unknowns_;
    std::span<Cone> cones_;
    std::span<HalfSpace> halfSpaces_;
    std::size_t coneCount_ = 0;
    std::size_t halfSpaceCount_ = 0;
};

/// From near `y`. False, with `y` as it may be, when no y is within all half-spaces. Takes no
/// memory from the heap (see Scratch).
///
/// First a sequence of quadratic programs shows which cones and half-spaces hold the minimum, and
/// Newton's method on their conditions of Karush, Kuhn and Tucker ends it and proves it. Where that
/// does not do, the method of centers (S. Boyd, L. El Ghaoui, Linear Algebra Appl. 188, 1993), to
/// `tolerance` of s.
bool minimise(const QuasiConvexProgram& program, Eigen::Ref<Eigen::VectorXd> y, double tolerance);

}  // namespace simcore::statics
