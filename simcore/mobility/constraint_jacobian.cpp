#include "simcore/mobility/constraint_jacobian.h"

#include "simcore/mobility/constraint_system.h"

namespace simcore::mobility {

ConstraintJacobian constraintJacobian(const mechanism::Mechanism& mechanism, Model model) {
    return constraintJacobian(mechanism, model, drawnStance(mechanism));
}

ConstraintJacobian constraintJacobian(const mechanism::Mechanism& mechanism, Model model,
                                      const Stance& stance) {
    return ConstraintSystem(mechanism, model, stance).jacobian();
}

}  // namespace simcore::mobility
