#pragma once

#include <optional>
#include <utility>

#include "simcore/base/problem.h"

namespace simcore {

/// A value, or the reasons why there is none. Warnings may accompany a value.
///
/// Used for failures that a user can cause (a file, an expression, a terrain); a caller's mistake
/// is an exception instead (std::invalid_argument).
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : value_(std::move(value)) {}  // NOLINT(google-explicit-constructor)

    Result(T value, Problems warnings) : value_(std::move(value)), problems_(std::move(warnings)) {}

    Result(Problem problem)
        : problems_{std::move(problem)} {}  // NOLINT(google-explicit-constructor)

    Result(Problems problems) : problems_(std::move(problems)) {}  // NOLINT

    explicit operator bool() const { return value_.has_value(); }

    bool ok() const { return value_.has_value(); }

    const T& value() const& { return value_.value(); }

    T& value() & { return value_.value(); }

    T&& value() && { return std::move(value_).value(); }

    const T* operator->() const { return &value_.value(); }

    const T& operator*() const { return value_.value(); }

    const Problems& problems() const& { return problems_; }

    Problems problems() && { return std::move(problems_); }

  private:
    std::optional<T> value_;
    Problems problems_;
};

}  // namespace simcore
