#pragma once

#include <array>
#include <optional>
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
/// two iterations, each as long as brings it nearest to the laws. What a body's contacts push is
/// added up in its twist first, six by six: the rates of a floating root are that twist, and the
/// others of a wheel are few. Where it cycles all the same, nonsmooth nonlinear conjugate gradients
/// (M. Silcowitz, S. Niebe and K. Erleben, Visual Computer 26, 2010) converge, slowly; every now
/// and then Newton's method is tried again from where they are.
namespace simcore::dynamics {

using Mat6 = Eigen::Matrix<double, 6, 6>;
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

    /// Makes it a zero matrix with columns beyond the square: one for a right side, and some that
    /// stay zero.
    void shape(RowMajor& matrix) const;
    /// Factors a matrix of that shape in place and takes its right side through the elimination.
    /// Elements outside the pattern are to be zero.
    void factor(RowMajor& matrix) const;
    void solve(const RowMajor& factored, Eigen::VectorXd& x) const;
    /// The solution for the right side in the column after the square.
    void solveCarried(const RowMajor& factored, Eigen::VectorXd& x) const;

  private:
    /// Rows are some ten elements long: run over in whole blocks of this many columns.
    static constexpr int kBlock = 4;

    void substituteBack(const RowMajor& factored, Eigen::VectorXd& x) const;

    int size_ = 0;
    std::vector<std::vector<bool>> pattern_;
    std::vector<std::vector<int>> after_;  ///< of every pivot, the later rows it meets
    std::vector<std::vector<int>>
        blocks_;  ///< first columns of blocks with them and the right side
};

/// How a body's twist follows from independent rates.
struct RateMap {
    /// Those that are the twist of the floating root it hangs from.
    std::optional<std::array<int, 6>> root;
    std::vector<int> indices;  ///< of the others
    std::vector<Vec6> twists;  ///< per index
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
    RowMajor mass;             ///< A, implicit forces included, shaped as PatternedLu asks for
    Eigen::VectorXd momentum;  ///< g
    std::vector<RateMap> bodies;
    std::vector<int> touched;  ///< bodies that have contacts; the maps of others are not looked at
    std::vector<ContactRow> contacts;
    std::span<ScalarRow> rows;
    double contactMass = 1.0;           ///< what a contact moves, roughly [kg]
    double normalCompliance = 0.0;      ///< e_n [1/kg]
    double tangentialCompliance = 0.0;  ///< e_t [1/kg]
    double tolerance = 0.0;             ///< of impulses [N s]
};

/// r of the natural map that accuracy is measured by [kg].
inline constexpr double kProjectionMass = 0.02;

/// A contact's law in one of its states: p = push - stiffness v. An open one pushes nothing.
struct ContactLaw {
    bool touches = false;
    Vec3 push = Vec3::Zero();
    Mat3 stiffness = Mat3::Zero();
};

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
    enum class Way { Quick, Slow };

    bool newton(ImpulseProblem& problem, const PatternedLu& lu, Way way, Eigen::VectorXd& u,
                ImpulseCounters& counters);
    void startAgain(ImpulseProblem& problem, Eigen::VectorXd& u) const;
    bool oneWay(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                ImpulseCounters& counters);
    bool withinLimits(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                      ImpulseCounters& counters);
    bool limitsHold(ImpulseProblem& problem, const Eigen::VectorXd& u);
    void gradients(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                   ImpulseCounters& counters);
    void sweep(ImpulseProblem& problem, double* impulses) const;

    /// What a linear solution asks of a contact.
    struct Asked {
        Vec3 impulse;   ///< [N s]
        Vec3 velocity;  ///< [m/s]
    };

    void addContacts(const ImpulseProblem& problem);
    void addRoot(const std::array<int, 6>& indices, const Mat6& stiffness, const Vec6& push);
    void addBody(const RateMap& body, const Mat6& stiffness, const Vec6& push);
    void addRows(const ImpulseProblem& problem);
    Vec3 impulseAt(std::size_t index, const ContactRow& contact, Way way, double share) const;
    double merit(const ImpulseProblem& problem, Way way, double share) const;
    double bestShare(const ImpulseProblem& problem, Way way) const;

    RowMajor matrix_;               ///< with the right side beside it
    std::vector<ContactLaw> laws_;  ///< of every contact
    std::vector<Asked> asked_;      ///< of every contact
    std::vector<int> limits_;       ///< per scalar row: -1, 0, 1 where it is held at a limit
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
