#include "simcore/review/review.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "simcore/base/text.h"
#include "simcore/dynamics/engine.h"

namespace simcore::review {
namespace {

using mechanism::Mechanism;
using mechanism::Wheel;
using project::Project;
using project::Scenario;
using Point = Eigen::Vector2d;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Collects the findings about one rover.
class Reviewer {
  public:
    Reviewer(const Project& project, const project::ParameterValues& parameters,
             const Mechanism& mechanism)
        : project_(project),
          parameters_(parameters),
          mechanism_(mechanism) {}

    std::vector<Finding> findings;

    void mobility(const mobility::Report& built, const mobility::Report& relaxed) {
        const std::string rover = Text::of("rover {}", project_.rover.name);
        if (mechanism_.wheels.empty()) {
            return;
        }
        if (built.mobility < 1) {
            add("cannot-move", Severity::Warning, rover,
                Text::of("as built it has mobility {} of at least 1: it cannot roll.",
                         built.mobility),
                Text::of("Give joints the freedoms it lacks."), built.mobility, 1.0);
        }
        if (built.redundant > 0 && relaxed.redundant > 0) {
            add("hyperstatic", Severity::Warning, rover,
                Text::of("{} constraints are redundant, and the relaxed model leaves {} of them.",
                         built.redundant, relaxed.redundant),
                Text::of("Ask the Advisor in Mobility what to free."), relaxed.redundant, 0.0);
        }
        if (!built.idle.empty()) {
            add("idle", Severity::Info, Text::of("body {}", built.idle.front().body),
                Text::of("{} of its motions move neither chassis nor wheels.", built.idle.size()),
                Text::of("Hold them by another type of joint, or leave them if nothing can jam."),
                static_cast<double>(built.idle.size()), 0.0);
        }
    }

    void masses() {
        const mechanism::Body* lightest = nullptr;
        const mechanism::Body* heaviest = nullptr;
        double size = 0.0;
        for (const Wheel& wheel : mechanism_.wheels) {
            size = std::max(size, (wheel.center - mechanism_.centerOfMass()).norm());
        }
        for (const mechanism::Body& body : mechanism_.bodies) {
            if (body.fixed || !(body.mass > 0.0)) {
                continue;
            }
            lightest = lightest == nullptr || body.mass < lightest->mass ? &body : lightest;
            heaviest = heaviest == nullptr || body.mass > heaviest->mass ? &body : heaviest;
            inertia(body, size);
        }
        if (lightest == nullptr || heaviest->mass <= kMostMassRatio * lightest->mass) {
            return;
        }
        const double ratio = heaviest->mass / lightest->mass;
        add("mass-ratio", Severity::Warning, Text::of("body {}", lightest->name),
            Text::of("it has {:.3g} kg, {:.0f} times less than {} (limit {:.0f}): engines that "
                     "iterate lose accuracy.",
                     lightest->mass, ratio, heaviest->name, kMostMassRatio),
            Text::of("Give it the mass of the real part, or weld it to its neighbour."), ratio,
            kMostMassRatio);
    }

    void feet() {
        if (mechanism_.wheels.size() < 2) {
            return;
        }
        const auto footOf = [](const Wheel& wheel) { return wheel.center.z() - wheel.radius; };
        double lowest = std::numeric_limits<double>::infinity();
        for (const Wheel& wheel : mechanism_.wheels) {
            lowest = std::min(lowest, footOf(wheel));
        }
        for (const Wheel& wheel : mechanism_.wheels) {
            const double height = footOf(wheel) - lowest;
            if (height > kOffGround) {
                add("off-ground", Severity::Warning, Text::of("wheel {}", wheel.name),
                    Text::of("it is drawn {:.1f} mm above the lowest wheel (limit {:.0f} mm).",
                             1e3 * height, 1e3 * kOffGround),
                    Text::of("Put its axle one radius above the ground."), height, kOffGround);
            }
        }
        const auto margin = supportMargin(mechanism_);
        if (!margin) {
            return;
        }
        double halfTrack = 0.0;
        for (const Wheel& wheel : mechanism_.wheels) {
            halfTrack = std::max(halfTrack, std::abs(wheel.center.y()));
        }
        const double size = std::min(0.5 * mechanism_.wheelbase(), halfTrack);
        if (*margin < kLeastSupport * size) {
            add("support", *margin < 0.0 ? Severity::Warning : Severity::Info,
                Text::of("rover {}", project_.rover.name),
                *margin < 0.0
                    ? Text::of("its centre of mass lies {:.0f} mm outside its feet: it tips.",
                               -1e3 * *margin)
                    : Text::of("its centre of mass lies only {:.0f} mm inside its feet (limit "
                               "{:.0f} mm).",
                               1e3 * *margin, 1e3 * kLeastSupport * size),
                Text::of("Move mass or wheels."), *margin, kLeastSupport * size);
        }
    }

    /// Wheels that stand in one another.
    void overlaps() {
        const auto& wheels = mechanism_.wheels;
        for (std::size_t i = 0; i < wheels.size(); ++i) {
            for (std::size_t k = i + 1; k < wheels.size(); ++k) {
                const Vec3 way = wheels[k].center - wheels[i].center;
                const double aside = std::abs(way.dot(wheels[i].axis));
                const double apart = (way - way.dot(wheels[i].axis) * wheels[i].axis).norm();
                const double deep = wheels[i].radius + wheels[k].radius - apart;
                const bool beside = aside >= 0.5 * (wheels[i].width + wheels[k].width);
                if (deep > 0.0 && !beside) {
                    add("overlap", Severity::Warning, Text::of("wheel {}", wheels[k].name),
                        Text::of("it stands {:.0f} mm deep in wheel {}.", 1e3 * deep,
                                 wheels[i].name),
                        Text::of("Move one of them, or make them smaller."), deep, 0.0);
                }
            }
        }
    }

    void scenarios() {
        for (const Scenario& scenario : project_.scenarios) {
            // A variant is another rover than the one at hand.
            if (!scenario.variant.empty() || mechanism_.wheels.empty()) {
                continue;
            }
            const auto values = project::evaluateScenario(scenario, parameters_);
            if (values) {
                step(scenario, *values);
                slope(scenario, *values);
            }
        }
    }

  private:
    void add(std::string kind, Severity severity, std::string element, std::string reason,
             std::string remedy, double value, double limit, std::optional<Fix> fix = {}) {
        findings.push_back({std::move(kind), severity, std::move(element), std::move(reason),
                            std::move(remedy), value, limit, std::move(fix)});
    }

    void inertia(const mechanism::Body& body, double size) {
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(body.inertia, Eigen::EigenvaluesOnly);
        const double least = std::sqrt(std::max(0.0, solver.eigenvalues()[0]) / body.mass);
        const double most = std::sqrt(std::max(0.0, solver.eigenvalues()[2]) / body.mass);
        if (least < kThinnestGyration) {
            add("inertia", Severity::Info, Text::of("body {}", body.name),
                Text::of("its least radius of gyration is {:.2f} mm (limit {:.0f} mm): it turns "
                         "as easily as a needle.",
                         1e3 * least, 1e3 * kThinnestGyration),
                Text::of("Check its inertia, or leave it away to have that of its shapes."), least,
                kThinnestGyration);
        } else if (size > 0.0 && most > kWidestGyration * size) {
            add("inertia", Severity::Warning, Text::of("body {}", body.name),
                Text::of("its radius of gyration is {:.2f} m, {:.1f} times the rover's size "
                         "(limit {:.0f}).",
                         most, most / size, kWidestGyration),
                Text::of("Check its inertia: kg m^2, about its own centre of mass."), most,
                kWidestGyration * size);
        }
    }

    void step(const Scenario& scenario, const project::ScenarioValues& values) {
        double radius = std::numeric_limits<double>::infinity();
        for (const Wheel& wheel : mechanism_.wheels) {
            radius = std::min(radius, wheel.radius);
        }
        const double way = std::abs(values.speed) * values.step;
        if (way <= kMostWayPerStep * radius) {
            return;
        }
        // A round number below the limit.
        const double most = kMostWayPerStep * radius / std::abs(values.speed);
        const double decade = std::pow(10.0, std::floor(std::log10(most)));
        const double round = (most >= 5.0 * decade   ? 5.0
                              : most >= 2.0 * decade ? 2.0
                                                     : 1.0) *
                             decade;
        Project fixed = project_;
        for (Scenario& one : fixed.scenarios) {
            if (one.name == scenario.name) {
                one.run.step = round;
            }
        }
        add("step", Severity::Warning, Text::of("scenario {}", scenario.name),
            Text::of("the rover goes {:.2f} mm in a step of {:.3g} ms (limit {:.2f} mm, a "
                     "hundredth of a wheel's radius): contacts are met too late.",
                     1e3 * way, 1e3 * values.step, 1e3 * kMostWayPerStep * radius),
            Text::of("Take a smaller step or a lower speed."), way, kMostWayPerStep * radius,
            Fix{Text::of("Step of {:.3g} ms", 1e3 * round), std::move(fixed)});
    }

    /// What an even slope asks for, whatever the suspension does: tan(slope) of friction, and
    /// m g sin(slope) of traction.
    void slope(const Scenario& scenario, const project::ScenarioValues& values) {
        const auto kind = scenario.terrain.kind;
        if (kind != project::TerrainKind::Ramp && kind != project::TerrainKind::CrossSlope) {
            return;
        }
        const auto angle = project::evaluate(scenario.terrain.slope, parameters_, scenario.name);
        if (!angle) {
            return;
        }
        const double friction = std::tan(std::abs(*angle));
        if (friction > values.friction) {
            add("friction", Severity::Warning, Text::of("scenario {}", scenario.name),
                Text::of("its slope of {:.1f} deg asks for a friction of {:.2f}, and the ground "
                         "gives {:.2f}.",
                         *angle / kDegree, friction, values.friction),
                Text::of("Lower the slope or raise the friction."), values.friction, friction);
        }
        double traction = 0.0;
        for (const Wheel& wheel : mechanism_.wheels) {
            traction += wheel.torqueLimit / wheel.radius;
        }
        const double weight = mechanism_.mass() * dynamics::kGravity;
        const double needed = weight * (std::sin(std::abs(*angle)) +
                                        values.rollingResistance * std::cos(std::abs(*angle)));
        if (kind == project::TerrainKind::Ramp && traction < needed) {
            add("torque", Severity::Warning, Text::of("scenario {}", scenario.name),
                Text::of("its slope of {:.1f} deg asks for {:.0f} N of traction, and all motors "
                         "together give {:.0f} N.",
                         *angle / kDegree, needed, traction),
                Text::of("Take stronger motors, smaller wheels or a lower slope."), traction,
                needed);
        }
    }

    const Project& project_;
    const project::ParameterValues& parameters_;
    const Mechanism& mechanism_;
};

double cross(const Point& a, const Point& b, const Point& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Counter-clockwise; A. M. Andrew, Information Processing Letters 9, 1979.
std::vector<Point> hullOf(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Point> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t first = hull.size();
        for (const Point& point : points) {
            while (hull.size() >= first + 2 &&
                   cross(hull[hull.size() - 2], hull.back(), point) <= 1e-12) {
                hull.pop_back();
            }
            hull.push_back(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace

std::optional<double> supportMargin(const Mechanism& mechanism) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Wheel& wheel : mechanism.wheels) {
        lowest = std::min(lowest, wheel.center.z() - wheel.radius);
    }
    std::vector<Point> feet;
    for (const Wheel& wheel : mechanism.wheels) {
        if (wheel.center.z() - wheel.radius < lowest + kOffGround) {
            feet.emplace_back(wheel.center.x(), wheel.center.y());
        }
    }
    if (feet.size() < 3) {
        return std::nullopt;
    }
    const std::vector<Point> hull = hullOf(feet);
    if (hull.size() < 3) {
        return std::nullopt;
    }
    const Point com(mechanism.centerOfMass().x(), mechanism.centerOfMass().y());
    double margin = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point& a = hull[i];
        const Point& b = hull[(i + 1) % hull.size()];
        margin = std::min(margin, cross(a, b, com) / (b - a).norm());
    }
    return margin;
}

Problem asProblem(const Finding& finding) {
    return {finding.severity, finding.element, finding.reason, finding.remedy};
}

std::vector<std::pair<std::string, std::string>> kinds() {
    return {{"cannot-move", Text::of("Cannot move")},
            {"hyperstatic", Text::of("Redundant constraints")},
            {"idle", Text::of("Idle freedoms")},
            {"mass-ratio", Text::of("Mass ratio")},
            {"inertia", Text::of("Inertia")},
            {"off-ground", Text::of("Wheel off the ground")},
            {"support", Text::of("Centre of mass near the edge of its feet")},
            {"overlap", Text::of("Wheels in one another")},
            {"step", Text::of("Step too large for the speed")},
            {"friction", Text::of("Too little friction for a scenario")},
            {"torque", Text::of("Too little torque for a scenario")}};
}

std::vector<Finding> review(const Project& project, const project::ParameterValues& parameters,
                            const Mechanism& mechanism, const mobility::Report& built,
                            const mobility::Report& relaxed) {
    Reviewer reviewer(project, parameters, mechanism);
    reviewer.mobility(built, relaxed);
    reviewer.masses();
    reviewer.feet();
    reviewer.overlaps();
    reviewer.scenarios();
    std::stable_sort(reviewer.findings.begin(), reviewer.findings.end(),
                     [](const Finding& a, const Finding& b) {
                         return static_cast<int>(a.severity) > static_cast<int>(b.severity);
                     });
    return std::move(reviewer.findings);
}

}  // namespace simcore::review
