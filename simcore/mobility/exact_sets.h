#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

/// The search behind the Advisor, as plain linear algebra: it knows numbers, not joints.
///
/// J is the constraint Jacobian as built and the h columns of S its self-stress states, so
/// J^T S = 0. Letting go of directions f_1 .. f_k leaves the self-stress states S c with
/// f_i . S c = 0. With the rows f_i^T S stacked into F that are h - rank F, and the rank of J falls
/// by k - rank F. So the mechanism becomes determinate, and moves as before, exactly when F is
/// square and regular: the exact sets are the bases of a linear matroid of small rank, and no
/// candidate needs an analysis of its own.
namespace simcore::mobility {

/// One way to change an element.
struct Choice {
    int cost = 0;  ///< points, at least 1
    /// A row per direction let go: the direction's reaction in each self-stress state.
    Eigen::MatrixXd relieved;
};

/// One choice or none for every element, so that nothing is redundant and nothing new moves.
struct ExactSet {
    std::vector<int> choice;  ///< per element; -1 = as built
    int cost = 0;
    /// Least singular value of F, 0 to 1: how far the set is from leaving something redundant.
    double margin = 0.0;
};

/// Finds all exact sets in the order of their cost: depth first within one cost, cut where the
/// directions so far depend on each other, where the elements left cannot make up for what is still
/// redundant, or where cost and count cannot both come out.
class ExactSetSearch {
  public:
    /// @param elements   choices of every element; elements that act together next to each other
    /// @param redundant  h; every choice has as many columns
    ExactSetSearch(std::vector<std::vector<Choice>> elements, int redundant);

    /// Costs at which sets can be, by cost and count alone; ascending.
    const std::vector<int>& costs() const { return costs_; }

    /// Calls `found` with every exact set of this cost, always in the same order. `stop` is asked
    /// every now and then; false: it said so, and sets may be missing.
    bool visit(int cost, const std::function<bool()>& stop,
               const std::function<void(const ExactSet&)>& found);

  private:
    bool canEnd(std::size_t element, int rows, int cost) const;
    bool othersCanFollow(std::size_t element) const;
    bool add(const Eigen::MatrixXd& relieved);
    void descend(std::size_t element, int costLeft);
    double margin() const;

    std::vector<std::vector<Choice>> elements_;
    int redundant_;
    int mostCost_ = 0;
    /// Per element, rows and cost: can the elements from this one on take exactly these?
    std::vector<std::vector<char>> canEnd_;
    /// Per element: orthonormal columns, what no choice of the elements from this one on relieves.
    std::vector<Eigen::MatrixXd> unreachable_;
    std::vector<int> costs_;

    // One visit:
    const std::function<bool()>* stop_ = nullptr;
    const std::function<void(const ExactSet&)>* found_ = nullptr;
    bool stopped_ = false;
    int steps_ = 0;
    int cost_ = 0;
    int size_ = 0;           ///< directions let go so far
    Eigen::MatrixXd basis_;  ///< orthonormal columns, the first size_ span their reactions
    std::vector<int> choice_;
};

}  // namespace simcore::mobility
