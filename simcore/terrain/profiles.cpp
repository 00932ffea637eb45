#include "simcore/terrain/profiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/base/random.h"

namespace simcore::terrain {
namespace {

using std::numbers::pi;

/// Angle of a chord of a circle whose sagitta is kChordError.
double chordAngle(double radius) {
    return 2.0 * std::acos(1.0 - kChordError / radius);
}

}  // namespace

void addPoint(Profile& profile, double x, double z) {
    const Eigen::Vector2d point(x, z);
    if (profile.empty() || (profile.back() - point).norm() > 1e-9) {
        profile.push_back(point);
    }
}

void addStep(Profile& profile, double x, double height, double length) {
    const double base = profile.back().y();
    addPoint(profile, x, base);
    addPoint(profile, x, base + height);
    if (length > 0.0) {
        addPoint(profile, x + length, base + height);
        addPoint(profile, x + length, base);
    }
}

void addRamp(Profile& profile, double x, double slope, double run) {
    const double base = profile.back().y();
    addPoint(profile, x, base);
    addPoint(profile, x + run, base + run * std::tan(slope));
}

void addStairs(Profile& profile, double x, double height, double length, int count) {
    for (int i = 0; i < count; ++i) {
        addStep(profile, x + i * length, height, 0.0);
        addPoint(profile, x + (i + 1) * length, profile.back().y());
    }
}

void addSinus(Profile& profile, double x, double height, double wavelength, int count) {
    const double base = profile.back().y();
    // Sagitta of a chord d on curvature k: k d^2 / 8; the greatest curvature is h/2 (2 pi / L)^2.
    const double curvature = 0.5 * height * std::pow(2.0 * pi / wavelength, 2);
    const int pieces =
        std::max(16, static_cast<int>(wavelength / std::sqrt(8.0 * kChordError / curvature)) + 1);
    for (int i = 0; i <= count * pieces; ++i) {
        const double phase = static_cast<double>(i) / pieces;
        addPoint(profile, x + phase * wavelength,
                 base + 0.5 * height * (1.0 - std::cos(2.0 * pi * phase)));
    }
}

void addCircles(Profile& profile, double x, double radius, double height, double spacing,
                int count) {
    const double base = profile.back().y();
    // A cap of height h: half the opening angle is acos(1 - h / r).
    const double half = std::acos(1.0 - std::min(height, radius) / radius);
    const double width = 2.0 * radius * std::sin(half);
    const int pieces = std::max(8, static_cast<int>(2.0 * half / chordAngle(radius)) + 1);
    for (int bump = 0; bump < count; ++bump) {
        const double middle = x + bump * std::max(spacing, width) + 0.5 * width;
        for (int i = 0; i <= pieces; ++i) {
            const double angle = -half + 2.0 * half * i / pieces;
            addPoint(profile, middle + radius * std::sin(angle),
                     base + radius * (std::cos(angle) - std::cos(half)));
        }
    }
}

void addRandom(Profile& profile, double x, double length, double height, int count, int seed) {
    Random random(static_cast<std::uint64_t>(static_cast<std::uint32_t>(seed)));
    const double base = profile.back().y();
    const double share = length / count;
    for (int i = 0; i < count; ++i) {
        const double begin = x + i * share;
        const double gap = random.uniform(0.05, 0.2) * share;
        const double room = share - gap;
        const double h = height * random.uniform(0.4, 1.0);
        switch (random.next() % 3) {
            case 0:  // a step up and down again
                addStep(profile, begin + gap, h, room * random.uniform(0.6, 1.0));
                break;
            case 1:  // one wave
                addSinus(profile, begin + gap, h, room, 1);
                break;
            default: {  // a cap that fills its room or stays at the height
                const double width = room * random.uniform(0.5, 1.0);
                const double cap = std::min(h, 0.5 * width);
                const double radius = (0.25 * width * width + cap * cap) / (2.0 * cap);
                addCircles(profile, begin + gap, radius, cap, 0.0, 1);
                break;
            }
        }
        addPoint(profile, std::max(begin + share, profile.back().x()), base);
    }
}

}  // namespace simcore::terrain
