#pragma once

#include <functional>

#include <Eigen/Core>

namespace testsupport {

/// y' = derivative(y) over `time` by the classical method of fourth order in `steps` steps: the
/// independent route to motions that have no closed form.
inline Eigen::VectorXd rungeKutta(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& derivative, Eigen::VectorXd y,
    double time, int steps) {
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const Eigen::VectorXd a = derivative(y);
        const Eigen::VectorXd b = derivative(y + 0.5 * h * a);
        const Eigen::VectorXd c = derivative(y + 0.5 * h * b);
        const Eigen::VectorXd d = derivative(y + h * c);
        y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return y;
}

}  // namespace testsupport
