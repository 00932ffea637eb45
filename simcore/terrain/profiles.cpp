#include "simcore/terrain/profiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/base/random.h"

namespace simcore::terrain {
namespace {

using std::numbers::pi;

/// Points at the same x to this share of a micrometre make one [m].
constexpr double kSameX = 1e-9;

/// x of all points, each once, in order.
std::vector<double> breakpoints(const std::vector<Profile>& profiles) {
    std::vector<double> all;
    for (const Profile& profile : profiles) {
        for (const Eigen::Vector2d& p : profile) {
            all.push_back(p.x());
        }
    }
    std::sort(all.begin(), all.end());
    all.erase(
        std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < kSameX; }),
        all.end());
    return all;
}

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

std::pair<double, double> heightsAt(const Profile& profile, double x) {
    const auto before = [](const Eigen::Vector2d& p, double value) { return p.x() < value; };
    const auto after = [](double value, const Eigen::Vector2d& p) { return value < p.x(); };
    const auto first = std::lower_bound(profile.begin(), profile.end(), x - kSameX, before);
    const auto past = std::upper_bound(first, profile.end(), x + kSameX, after);
    if (first != past) {  // points at x itself
        return {first->y(), (past - 1)->y()};
    }
    if (first == profile.begin() || first == profile.end()) {
        const double level = first == profile.end() ? profile.back().y() : profile.front().y();
        return {level, level};
    }
    const Eigen::Vector2d& a = *(first - 1);
    const Eigen::Vector2d& b = *first;
    const double z = a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
    return {z, z};
}

Profile sum(const std::vector<Profile>& profiles) {
    Profile total;
    for (const double x : breakpoints(profiles)) {
        double before = 0.0;
        double after = 0.0;
        for (const Profile& profile : profiles) {
            const auto [b, a] = heightsAt(profile, x);
            before += b;
            after += a;
        }
        addPoint(total, x, before);
        addPoint(total, x, after);
    }
    return total;
}

TriangleMesh meshOfSides(const Profile& left, const Profile& right, double halfWidth) {
    TriangleMesh mesh;
    const auto vertex = [&mesh](double x, double y, double z) {
        mesh.vertices.emplace_back(x, y, z);
        return static_cast<int>(mesh.vertices.size()) - 1;
    };
    // Both get points at the same x, so that wall and strips share their corners.
    const std::vector<double> stations = breakpoints({left, right});
    const auto addStrip = [&](const Profile& profile, double yMin, double yMax) {
        int near[2] = {-1, -1};
        for (const double x : stations) {
            const auto [before, after] = heightsAt(profile, x);
            for (const double z : {before, after}) {
                if (z == after && z == before && near[0] >= 0 &&
                    mesh.vertices[static_cast<std::size_t>(near[0])] == Vec3(x, yMin, z)) {
                    continue;  // no face here
                }
                const int far[2] = {vertex(x, yMin, z), vertex(x, yMax, z)};
                if (near[0] >= 0) {
                    mesh.triangles.push_back({near[0], far[0], near[1]});
                    mesh.triangles.push_back({near[1], far[0], far[1]});
                }
                near[0] = far[0];
                near[1] = far[1];
            }
        }
    };
    addStrip(right, -halfWidth, 0.0);
    addStrip(left, 0.0, halfWidth);
    // The wall looks to the lower side; where the two cross it changes over.
    const auto addWall = [&](double x0, double x1, double low0, double low1, double high0,
                             double high1, bool looksRight) {
        const auto triangle = [&](int a, int b, int c) {
            mesh.triangles.push_back(looksRight ? std::array{a, b, c} : std::array{a, c, b});
        };
        const int a = vertex(x0, 0.0, low0);
        const int b = vertex(x1, 0.0, low1);
        const int c = vertex(x1, 0.0, high1);
        const int d = vertex(x0, 0.0, high0);
        if (high1 > low1) {
            triangle(a, b, c);
        }
        if (high0 > low0) {
            triangle(a, c, d);
        }
    };
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
        double x0 = stations[i];
        const double x1 = stations[i + 1];
        double l0 = heightsAt(left, x0).second;
        double r0 = heightsAt(right, x0).second;
        const double l1 = heightsAt(left, x1).first;
        const double r1 = heightsAt(right, x1).first;
        if ((l0 - r0) * (l1 - r1) < 0.0) {
            const double share = (l0 - r0) / ((l0 - r0) - (l1 - r1));
            const double x = x0 + share * (x1 - x0);
            const double z = l0 + share * (l1 - l0);
            l0 > r0 ? addWall(x0, x, r0, z, l0, z, true) : addWall(x0, x, l0, z, r0, z, false);
            x0 = x;
            l0 = r0 = z;
        }
        if (l0 + l1 > r0 + r1) {
            addWall(x0, x1, r0, r1, l0, l1, true);
        } else {
            addWall(x0, x1, l0, l1, r0, r1, false);
        }
    }
    return mesh;
}

}  // namespace simcore::terrain
