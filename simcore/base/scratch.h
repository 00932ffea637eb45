#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

#include <Eigen/Core>

namespace simcore {

/// Vectors, matrices and lists for the time of a calculation, whose sizes only it knows. They stand
/// on a stack that each thread has beside its own; once that has grown, nothing comes from the
/// heap. What one Scratch gave ends with it; of several, the last made gives and ends first.
class Scratch {
  public:
    using Vector = Eigen::Map<Eigen::VectorXd>;
    using Matrix = Eigen::Map<Eigen::MatrixXd>;

    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    /// Elements are not set.
    Vector vector(Eigen::Index size);
    Matrix matrix(Eigen::Index rows, Eigen::Index columns);

    /// A copy of what an expression of a vector comes to.
    template <class Expression>
    Vector vector(const Eigen::MatrixBase<Expression>& expression) {
        Vector result = vector(expression.size());
        result.noalias() = expression;
        return result;
    }

    /// Made by their default constructors.
    template <class T>
    std::span<T> list(std::size_t size) {
        static_assert(std::is_trivially_destructible_v<T> && alignof(T) <= alignof(double));
        constexpr std::size_t kWord = sizeof(double);
        auto* const first = reinterpret_cast<T*>(take((size * sizeof(T) + kWord - 1) / kWord));
        std::uninitialized_value_construct_n(first, size);
        return {first, size};
    }

  private:
    double* take(std::size_t words);

    struct Height {
        std::size_t block = 0;
        std::size_t words = 0;  ///< taken of it
    };

    struct Stack;
    static Stack& stack();

    Height before_;
    std::size_t depth_;  ///< how many there are with this one
};

}  // namespace simcore
