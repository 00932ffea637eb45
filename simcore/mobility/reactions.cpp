#include "simcore/mobility/reactions.h"

#include "simcore/base/text.h"
#include "simcore/mobility/constraint_system.h"
#include "simcore/mobility/factorisation.h"

namespace simcore::mobility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The component that weighs the rows from `begin` on by `weights`.
ReactionComponent componentOf(const ConstraintJacobian& jacobian, std::size_t begin,
                              const Eigen::VectorXd& weights, double length) {
    ReactionComponent component;
    component.lever = length;
    for (Index i = 0; i < weights.size(); ++i) {
        const ConstraintName& row = jacobian.names[begin + static_cast<std::size_t>(i)];
        (row.kind == "slide" ? component.force : component.torque) += weights[i] * row.direction;
    }
    return component;
}

ReactionDeterminacy reactionOf(const ConstraintJacobian& jacobian, const MatrixXd& selfStress,
                               std::size_t begin, std::size_t end, double length) {
    const ConstraintName& name = jacobian.names[begin];
    ReactionDeterminacy reaction;
    reaction.element = name.element;
    reaction.joint = name.kind == "gear" ? -1 : name.joint;
    reaction.wheel = name.wheel;
    const auto count = static_cast<Index>(end - begin);
    reaction.components = static_cast<int>(count);
    std::vector<Index> mixed;
    for (Index i = 0; i < count; ++i) {
        const std::size_t row = begin + static_cast<std::size_t>(i);
        const double share = selfStress.row(static_cast<Index>(row)).squaredNorm();
        if (share <= kNoShare) {
            reaction.determined.push_back(
                componentOf(jacobian, begin, Eigen::VectorXd::Unit(count, i), length));
        } else {
            mixed.push_back(i);
            reaction.undetermined.push_back(jacobian.names[row]);
            reaction.undetermined.back().share = share;
        }
    }
    if (!mixed.empty()) {
        // Weights c with c . stress = 0 in every self-stress state: the free motions, so to say, of
        // the stresses at this element.
        const MatrixXd stress =
            selfStress.middleRows(static_cast<Index>(begin), count)(mixed, Eigen::all);
        const Factorisation factors(stress.transpose());
        for (Index k = 0; k < factors.motions.cols(); ++k) {
            Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
            weights(mixed) = factors.motions.col(k);
            reaction.determined.push_back(componentOf(jacobian, begin, weights, length));
        }
    }
    const int found = static_cast<int>(reaction.determined.size());
    reaction.determinacy = found == reaction.components
                               ? Determinacy::All
                               : (found > 0 ? Determinacy::Some : Determinacy::None);
    return reaction;
}

}  // namespace

std::vector<ReactionDeterminacy> determinedReactions(const mechanism::Mechanism& mechanism,
                                                     Model model) {
    return determinedReactions(mechanism, model, drawnStance(mechanism));
}

std::vector<ReactionDeterminacy> determinedReactions(const mechanism::Mechanism& mechanism,
                                                     Model model, const Stance& stance) {
    const ConstraintJacobian jacobian = constraintJacobian(mechanism, model, stance);
    const MatrixXd selfStress = Factorisation(jacobian.matrix).selfStress;
    std::vector<ReactionDeterminacy> reactions;
    for (std::size_t begin = 0; begin < jacobian.names.size();) {
        std::size_t end = begin;
        const auto same = [&](const ConstraintName& a, const ConstraintName& b) {
            return a.joint == b.joint && a.wheel == b.wheel &&
                   (a.kind == "gear") == (b.kind == "gear") && a.element == b.element;
        };
        while (end < jacobian.names.size() && same(jacobian.names[begin], jacobian.names[end])) {
            ++end;
        }
        reactions.push_back(
            reactionOf(jacobian, selfStress, begin, end, characteristicLength(mechanism)));
        begin = end;
    }
    return reactions;
}

std::string describe(const std::vector<ReactionDeterminacy>& reactions) {
    constexpr std::size_t kNamed = 6;  // more is a list, not a sentence
    const auto named = [&](Determinacy determinacy) {
        std::size_t count = 0;
        std::string text;
        for (const ReactionDeterminacy& reaction : reactions) {
            if (reaction.determinacy == determinacy && ++count <= kNamed) {
                text += (count > 1 ? ", " : "") + reaction.element;
            }
        }
        return count > kNamed ? Text::of("{} and {} more", text, count - kNamed) : text;
    };
    int components = 0, known = 0;
    for (const ReactionDeterminacy& reaction : reactions) {
        components += reaction.components;
        known += static_cast<int>(reaction.determined.size());
    }
    if (known == components) {
        return Text::of("Every reaction follows from the loads.");
    }
    std::string text = Text::of(
        "Of {} components of reactions the loads determine {}; the others depend on play, "
        "stiffness and errors of manufacture.",
        components, known);
    if (const std::string none = named(Determinacy::None); !none.empty()) {
        text += " " + Text::of("Nothing can be known of {}.", none);
    }
    if (const std::string some = named(Determinacy::Some); !some.empty()) {
        text += " " + Text::of("Part of the reaction can be known of {}.", some);
    }
    return text;
}

}  // namespace simcore::mobility
