#pragma once

#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "simcore/dynamics/spatial.h"

/// One step's velocities under contacts, stops and motors.
///
/// The unknowns are the independent rates u of a mechanism:
///
///     A u = g + sum of what contacts, stops and motors push
///
/// A contact pushes with an impulse p at its point, whose velocity is v:
///
///     normal      p_n >= 0,  v_n + e_n p_n >= b,  one of them an equality
///     sticking    v_t + e_t p_t = 0  while  |p_t| <= mu p_n
///     sliding     p_t = -mu p_n v_t / |v_t|
///
/// that is Coulomb's cone with a little compliance, which makes the forces unique where wheels
/// share a load. Solved by semi-smooth Newton in u (A. Kurdila; P. Alart and A. Curnier, Comput.
/// Methods Appl. Mech. Eng. 92, 1991), which starts from the last step's impulses and needs one or
/// two iterations. Where it cycles it starts again with creepier sticking, which is taken back in
/// stages; where that cycles, too, nonsmooth nonlinear conjugate gradients (M. Silcowitz, S. Niebe
/// and K. Erleben, Visual Computer 26, 2010) converge, slowly.
namespace simcore::dynamics {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// LU elimination without pivoting of a matrix whose pattern of zeros is known.
class PatternedLu {
  public:
    /// Afresh for matrices of this size, with nothing off the diagonal.
    void reset(int size);
    /// These rows and columns meet in elements that are not zero.
    void couple(const std::vector<int>& indices);
    /// Adds what elimination fills.
    void close();

    /// Factors in place. Elements outside the pattern are not looked at.
    void factor(RowMajor& matrix) const;
    void solve(const RowMajor& factored, Eigen::VectorXd& x) const;

  private:
    int size_ = 0;
    std::vector<std::vector<bool>> pattern_;
    std::vector<std::vector<int>> after_;  ///< of every pivot, the later rows it meets
};

/// How the velocity of something follows from a few of the independent rates.
struct RateMap {
    std::vector<int> indices;
    /// Per index, twist of the body.
    std::vector<Vec6> twists;
};

struct ContactRow {
    int body = 0;                          ///< index into ImpulseProblem::bodies
    Eigen::Matrix<double, 6, 3> wrenches;  ///< unit impulses: normal and two tangential
    double friction = 0.0;
    double bound = 0.0;            ///< b [m/s]
    Vec3 impulse = Vec3::Zero();   ///< guess, then solution [N s]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// A push along one combination of rates: v + e p = b with p within limits.
struct ScalarRow {
    std::vector<int> indices;
    std::vector<double> factors;
    double compliance = 0.0;  ///< e
    double bound = 0.0;       ///< b [rad/s]
    double least = 0.0;       ///< [N m s]
    double most = 0.0;
    double impulse = 0.0;
    /// Where the iteration begins: -1 and 1 at the limits, 0 between them.
    int start = 0;
};

struct ImpulseProblem {
    RowMajor mass;             ///< A, implicit forces included
    Eigen::VectorXd momentum;  ///< g
    std::vector<RateMap> bodies;
    std::vector<int> touched;  ///< bodies that have contacts; the maps of others are not looked at
    std::vector<ContactRow> contacts;
    std::span<ScalarRow> rows;
    double normalCompliance = 0.0;      ///< e_n [1/kg]
    double tangentialCompliance = 0.0;  ///< e_t [1/kg]
    double tolerance = 0.0;             ///< of impulses [N s]
};

/// r of the natural map, and of the projection that tells touching from open [kg]; within 0.02 to
/// 0.2 kg it makes no difference.
inline constexpr double kProjectionMass = 0.02;

/// How far a contact is from its law, as the natural map's largest component [N s]. Its velocity
/// and impulse are looked at.
double naturalResidual(const ContactRow& contact, double normalCompliance,
                       double tangentialCompliance);

struct ImpulseCounters {
    long iterations = 0;  ///< Newton's
    long fallbacks = 0;   ///< steps that it did not solve
    long failures = 0;    ///< steps that nothing solved within the tolerance
    /// Worst of the natural map |p - proj(p - r (v + e p - b))| over all solves, with r =
    /// kProjectionMass [N s].
    double residual = 0.0;
};

class ImpulseSolver {
  public:
    /// Room for problems of this size, so that they take none from the heap.
    void reserve(std::size_t contacts, std::size_t rows, std::size_t rates);

    /// Solves for u, which comes with a guess, and for the impulses.
    void solve(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
               ImpulseCounters& counters);

  private:
    bool newton(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                ImpulseCounters& counters);
    bool newtonInStages(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                        ImpulseCounters& counters);
    bool withinLimits(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                      ImpulseCounters& counters);
    static double residualOf(const ImpulseProblem& problem);
    void gradients(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u);
    void sweep(ImpulseProblem& problem, double* impulses) const;

    RowMajor matrix_;
    Eigen::VectorXd right_;
    std::vector<Eigen::Matrix<double, 6, 6>> stiff_;  ///< per body
    std::vector<Vec6> push_;
    std::vector<std::pair<Vec3, Mat3>> laws_;  ///< p0 and C of every contact
    std::vector<int> limits_;  ///< per scalar row: -1, 0, 1 where it is held at a limit
    // What solving starts from.
    Eigen::VectorXd firstU_;
    std::vector<Vec3> firstImpulses_;
    // Of the gradients, with room that stays.
    std::vector<double> room_;
    double* delassus_ = nullptr;  ///< m x m, row by row
    Eigen::Index size_ = 0;       ///< m
    std::vector<double> free_;
};

}  // namespace simcore::dynamics
