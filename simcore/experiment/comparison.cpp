#include "simcore/experiment/comparison.h"

#include <algorithm>
#include <cmath>

#include "simcore/base/random.h"

namespace simcore::experiment {
namespace {

constexpr int kSamples = 2000;
constexpr double kTail = 0.025;

struct Pair {
    const Outcome* own;
    const Outcome* rival;
};

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

Comparison::Measure measure(const std::vector<Pair>& pairs, double Outcome::*what,
                            double resolution) {
    Comparison::Measure result;
    std::vector<double> logs;
    for (const Pair& pair : pairs) {
        const double less = pair.rival->*what - pair.own->*what;
        result.wins += less > resolution ? 1 : 0;
        result.ties += std::abs(less) <= resolution ? 1 : 0;
        logs.push_back(std::log(std::max(resolution, pair.rival->*what) /
                                std::max(resolution, pair.own->*what)));
    }
    if (logs.empty()) {
        return result;
    }
    result.meanRatio = std::exp(mean(logs));
    if (logs.size() < 2) {
        return result;
    }
    Random random(1);
    std::vector<double> means;
    std::vector<double> sample(logs.size());
    for (int k = 0; k < kSamples; ++k) {
        for (double& value : sample) {
            value = logs[random.next() % logs.size()];
        }
        means.push_back(mean(sample));
    }
    std::sort(means.begin(), means.end());
    const auto tail = static_cast<std::size_t>(kTail * kSamples);
    result.low = std::exp(means[tail]);
    result.high = std::exp(means[means.size() - 1 - tail]);
    return result;
}

const Outcome* find(const std::vector<Outcome>& outcomes, const Case& what) {
    const auto found = std::find_if(outcomes.begin(), outcomes.end(),
                                    [&](const Outcome& o) { return o.ran == what; });
    return found == outcomes.end() ? nullptr : &*found;
}

bool isAmong(Grounds grounds, const Outcome& outcome) {
    const bool passable = outcome.staticFriction <= kPassable * outcome.ran.friction;
    return grounds == Grounds::All || passable == (grounds == Grounds::Passable);
}

Comparison compareTwo(const Plan& plan, const std::vector<Outcome>& outcomes, Grounds grounds,
                      double friction, project::ControllerKind controller,
                      project::ControllerKind rival) {
    Comparison comparison;
    comparison.friction = friction;
    comparison.grounds = grounds;
    comparison.controller = controller;
    comparison.rival = rival;
    std::vector<Pair> valid;
    for (int seed = plan.firstSeed; seed <= plan.lastSeed; ++seed) {
        const Pair pair{find(outcomes, {seed, friction, controller}),
                        find(outcomes, {seed, friction, rival})};
        if (pair.own == nullptr || pair.rival == nullptr || !isAmong(grounds, *pair.own)) {
            continue;
        }
        ++comparison.tried;
        comparison.onlyOwn += pair.own->completed && !pair.rival->completed ? 1 : 0;
        comparison.onlyRival += pair.rival->completed && !pair.own->completed ? 1 : 0;
        if (!pair.own->completed || !pair.rival->completed) {
            continue;
        }
        ++comparison.pairs;
        const double apart =
            std::hypot(pair.own->endX - pair.rival->endX, pair.own->endY - pair.rival->endY);
        if (plan.set == TerrainSet::Profiles || apart < kSameEnd) {
            valid.push_back(pair);
        }
    }
    comparison.valid = static_cast<int>(valid.size());
    comparison.slip = measure(valid, &Outcome::slipAbs, kSlipResolution);
    comparison.loadedSlip = measure(valid, &Outcome::slipLoaded, kSlipResolution);
    comparison.energy = measure(valid, &Outcome::energy, kEnergyResolution);
    comparison.work = measure(valid, &Outcome::frictionWork, kEnergyResolution);
    return comparison;
}

}  // namespace

std::string toString(Grounds grounds) {
    switch (grounds) {
        case Grounds::Passable:
            return "passable";
        case Grounds::Beyond:
            return "beyond";
        case Grounds::All:
            break;
    }
    return "all";
}

std::vector<Comparison> compare(const Plan& plan, const std::vector<Outcome>& outcomes) {
    std::vector<Comparison> comparisons;
    for (const Grounds grounds : {Grounds::All, Grounds::Passable, Grounds::Beyond}) {
        for (const double friction : plan.frictions) {
            for (const project::ControllerKind controller : plan.controllers) {
                for (const project::ControllerKind rival : plan.controllers) {
                    if (rival != controller) {
                        comparisons.push_back(
                            compareTwo(plan, outcomes, grounds, friction, controller, rival));
                    }
                }
            }
        }
    }
    return comparisons;
}

}  // namespace simcore::experiment
