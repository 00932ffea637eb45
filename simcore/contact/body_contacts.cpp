#include "simcore/contact/body_contacts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace simcore::contact {
namespace {

using mechanism::Mechanism;
using mechanism::Shape;
using project::ShapeKind;

// Samples of one shape stand no further apart [m]; a rock under a belly is to be felt.
constexpr double kSampleSpacing = 0.03;
// Each quarter of a cylinder's rim has at least this many samples: the polygon of all leaves the
// circle by at most 2 % of the radius.
constexpr int kFewestOnQuarter = 4;
// A sample this far inside another shape is hidden by it [m]: more than rounding.
constexpr double kHidden = 1e-6;
// Cosine of the angle up to which a face of the ground looks at a face of the body, 73 deg
// (assumed): the belly of a body that slides onto a block meets the block's top, not its side.
constexpr double kLooksAt = 0.3;
// Ground steeper than 45 deg is a wall.
constexpr double kWall = std::numbers::sqrt2 / 2.0;
// Of points equally deep the outer ones count: they hold the body with long levers. Worth this much
// depth for each metre, 0.3 um from one sample to the next: above rounding, below what forces feel.
constexpr double kOutward = 1e-5;
// Points this near to the middle line of what touches belong to both sides of it [m].
constexpr double kOnLine = 1e-6;
// Faces of the ground this much further than the nearest are as near [m].
constexpr double kAsNear = 1e-9;

/// A shape's axes: boxes and bars along their edges, cylinders with x along the axis.
struct Frame {
    Vec3 center = Vec3::Zero();
    Mat3 axes = Mat3::Identity();
    Vec3 half = Vec3::Zero();  ///< of the box round the shape, along the axes [m]
};

// The same frames as the picture's.
Frame frameOf(const Shape& shape) {
    switch (shape.kind) {
        case ShapeKind::Box:
            return {shape.center, Eigen::AngleAxisd(shape.pitch, Vec3::UnitY()).toRotationMatrix(),
                    0.5 * shape.size};
        case ShapeKind::Sphere:
            return {shape.center, Mat3::Identity(), Vec3::Constant(shape.radius)};
        case ShapeKind::Cylinder:
        case ShapeKind::Bar:
            break;
    }
    const Vec3 along = shape.to - shape.from;
    const Vec3 x = along.normalized();
    const Vec3 up = std::abs(x.z()) < 0.99 ? Vec3::UnitZ() : Vec3::UnitX();
    const Vec3 y = up.cross(x).normalized();
    Frame frame;
    frame.center = 0.5 * (shape.from + shape.to);
    frame.axes << x, y, x.cross(y);
    frame.half = shape.kind == ShapeKind::Bar
                     ? Vec3(along.norm(), shape.width, shape.height) / 2.0
                     : Vec3(0.5 * along.norm(), shape.radius, shape.radius);
    return frame;
}

int piecesOf(double length) {
    return std::max(1, static_cast<int>(std::ceil(length / kSampleSpacing - 1e-9)));
}

void addFace(BodySample& sample, const Vec3& normal) {
    sample.faces[static_cast<std::size_t>(sample.faceCount++)] = normal;
}

std::vector<BodySample> samplesOfBox(const Frame& frame) {
    std::array<int, 3> pieces{};
    for (int k = 0; k < 3; ++k) {
        pieces[static_cast<std::size_t>(k)] = piecesOf(2.0 * frame.half[k]);
    }
    std::vector<BodySample> samples;
    std::array<int, 3> at{};
    for (at[0] = 0; at[0] <= pieces[0]; ++at[0]) {
        for (at[1] = 0; at[1] <= pieces[1]; ++at[1]) {
            for (at[2] = 0; at[2] <= pieces[2]; ++at[2]) {
                BodySample sample;
                Vec3 local;
                for (int k = 0; k < 3; ++k) {
                    const int i = at[static_cast<std::size_t>(k)];
                    const int n = pieces[static_cast<std::size_t>(k)];
                    local[k] = frame.half[k] * (2 * i - n) / n;
                    if (i == 0 || i == n) {
                        addFace(sample, (i == 0 ? -1.0 : 1.0) * frame.axes.col(k));
                    }
                }
                if (sample.faceCount > 0) {
                    sample.point = frame.center + frame.axes * local;
                    samples.push_back(sample);
                }
            }
        }
    }
    return samples;
}

std::vector<BodySample> samplesOfCylinder(const Frame& frame) {
    const double radius = frame.half.y();
    const Vec3 axis = frame.axes.col(0);
    const int along = piecesOf(2.0 * frame.half.x());
    const int rings = piecesOf(radius);
    std::vector<BodySample> samples;
    for (int i = 0; i <= along; ++i) {
        const bool end = i == 0 || i == along;
        const Vec3 middle = frame.center + axis * (frame.half.x() * (2 * i - along) / along);
        // Inwards to the axis on the ends, the rim alone between them.
        for (int ring = rings; ring >= (end ? 0 : rings); --ring) {
            const double r = radius * ring / rings;
            const int quarter = std::max(kFewestOnQuarter, piecesOf(0.5 * std::numbers::pi * r));
            const int count = ring == 0 ? 1 : 4 * quarter;
            for (int k = 0; k < count; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / count;
                const Vec3 outward =
                    std::cos(angle) * frame.axes.col(2) + std::sin(angle) * frame.axes.col(1);
                BodySample sample;
                sample.point = middle + r * outward;
                if (ring == rings) {
                    addFace(sample, outward);
                }
                if (end) {
                    addFace(sample, i == 0 ? Vec3(-axis) : axis);
                }
                samples.push_back(sample);
            }
        }
    }
    return samples;
}

bool isInside(const Vec3& point, const Shape& shape) {
    const Frame frame = frameOf(shape);
    const Vec3 local = frame.axes.transpose() * (point - frame.center);
    switch (shape.kind) {
        case ShapeKind::Sphere:
            return local.norm() < shape.radius - kHidden;
        case ShapeKind::Cylinder:
            return std::abs(local.x()) < frame.half.x() - kHidden &&
                   local.tail<2>().norm() < shape.radius - kHidden;
        case ShapeKind::Box:
        case ShapeKind::Bar:
            break;
    }
    return (local.cwiseAbs().array() < frame.half.array() - kHidden).all();
}

/// Whether a wheel that the body carries covers the point, however it turns on its axle.
bool isInWheel(const Vec3& point, const mechanism::Wheel& wheel) {
    const Vec3 arm = point - wheel.center;
    const double along = arm.dot(wheel.axis);
    return std::abs(along) < 0.5 * wheel.width && (arm - along * wheel.axis).norm() < wheel.radius;
}

bool isHidden(const Vec3& point, const Mechanism& mechanism, int body, const Shape& own) {
    const std::vector<Shape>& shapes = mechanism.bodies[static_cast<std::size_t>(body)].shapes;
    return std::any_of(
               shapes.begin(), shapes.end(),
               [&](const Shape& other) { return &other != &own && isInside(point, other); }) ||
           std::any_of(mechanism.wheels.begin(), mechanism.wheels.end(),
                       [&](const mechanism::Wheel& wheel) {
                           return wheel.carrier == body && isInWheel(point, wheel);
                       });
}

/// Point of the triangle that is nearest to p (C. Ericson: Real-Time Collision Detection, 2005,
/// section 5.1.5).
Vec3 nearestOn(const std::array<Vec3, 3>& triangle, const Vec3& p) {
    const Vec3& a = triangle[0];
    const Vec3& b = triangle[1];
    const Vec3& c = triangle[2];
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = ab.dot(p - a);
    const double d2 = ac.dot(p - a);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return a;
    }
    const double d3 = ab.dot(p - b);
    const double d4 = ac.dot(p - b);
    if (d3 >= 0.0 && d4 <= d3) {
        return b;
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        return a + d1 / (d1 - d3) * ab;
    }
    const double d5 = ab.dot(p - c);
    const double d6 = ac.dot(p - c);
    if (d6 >= 0.0 && d5 <= d6) {
        return c;
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        return a + d2 / (d2 - d6) * ac;
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    }
    const double sum = va + vb + vc;
    return a + vb / sum * ab + vc / sum * ac;
}

/// What of the ground is nearest to a point.
struct Nearest {
    Vec3 point;       ///< world [m]
    Vec3 normal;      ///< of its face
    double distance;  ///< [m], >= 0
    double height;    ///< of the point above the face's plane [m]
};

/// Of faces equally near, as two that share the nearest edge, the one comes first that the point is
/// furthest from the plane of: it tells on which side of the ground the point is.
bool comesBefore(const Nearest& a, const Nearest& b) {
    if (std::abs(a.distance - b.distance) > kAsNear) {
        return a.distance < b.distance;
    }
    const double further = std::abs(a.height) - std::abs(b.height);
    return std::abs(further) > kAsNear ? further > 0.0 : a.distance < b.distance;
}

/// Of those faces that look at the body.
template <class LooksAtBody>
std::optional<Nearest> nearestOf(const std::vector<terrain::Facet>& facets, const Vec3& p,
                                 const LooksAtBody& looksAtBody) {
    std::optional<Nearest> best;
    for (const terrain::Facet& facet : facets) {
        if (!looksAtBody(facet.normal)) {
            continue;
        }
        const Vec3 q = nearestOn(facet.corners, p);
        const double distance = (p - q).norm();
        const double height = facet.normal.dot(p - facet.corners[0]);
        const Nearest found{q, facet.normal, distance, height};
        if (!best || comesBefore(found, *best)) {
            best = found;
        }
    }
    return best;
}

/// Heading of a body in the plane; of one that stands on its nose, that of its top.
Vec3 levelForward(const Mat3& R) {
    const Vec3 forward = std::abs(R(2, 0)) < 0.99 ? Vec3(R.col(0)) : Vec3(-R(2, 0) * R.col(2));
    return Vec3(forward.x(), forward.y(), 0.0).normalized();
}

/// The direction along a face of the ground; against a wall, upwards.
Vec3 alongFace(const Vec3& forward, const Vec3& normal) {
    const Vec3 along = forward - forward.dot(normal) * normal;
    return along.norm() > 0.1 ? along.normalized()
                              : Vec3(Vec3::UnitZ() - normal.z() * normal).normalized();
}

}  // namespace

std::vector<BodySample> samplesOf(const Shape& shape) {
    const Frame frame = frameOf(shape);
    switch (shape.kind) {
        case ShapeKind::Sphere: {
            BodySample ball;
            ball.point = shape.center;
            ball.radius = shape.radius;
            return {ball};
        }
        case ShapeKind::Cylinder:
            return samplesOfCylinder(frame);
        case ShapeKind::Box:
        case ShapeKind::Bar:
            break;
    }
    return samplesOfBox(frame);
}

BodyContactFinder::BodyContactFinder(const Mechanism& mechanism, const terrain::Terrain& terrain,
                                     double margin, double deepest)
    : mechanism_(mechanism),
      terrain_(terrain),
      margin_(margin),
      deepest_(deepest) {
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        const int body = static_cast<int>(i);
        const bool isWheel =
            std::any_of(mechanism.wheels.begin(), mechanism.wheels.end(),
                        [&](const mechanism::Wheel& wheel) { return wheel.body == body; });
        if (!mechanism.bodies[i].fixed && !isWheel) {
            addPart(body);
        }
    }
}

void BodyContactFinder::addPart(int body) {
    Part part;
    part.body = body;
    Eigen::AlignedBox3d all;
    for (const Shape& shape : mechanism_.bodies[static_cast<std::size_t>(body)].shapes) {
        Patch patch;
        patch.first = part.samples.size();
        Eigen::AlignedBox3d box;
        for (const BodySample& sample : samplesOf(shape)) {
            if (sample.radius > 0.0 || !isHidden(sample.point, mechanism_, body, shape)) {
                part.samples.push_back(sample);
                box.extend(Vec3(sample.point.array() - sample.radius));
                box.extend(Vec3(sample.point.array() + sample.radius));
            }
        }
        patch.end = part.samples.size();
        if (patch.end > patch.first) {
            patch.bounds = {box.center(), 0.5 * box.sizes()};
            part.patches.push_back(patch);
            all.extend(box);
        }
    }
    if (!part.samples.empty()) {
        part.bounds = {all.center(), 0.5 * all.sizes()};
        part.farthest = part.bounds.center.norm() + part.bounds.half.norm();
        parts_.push_back(std::move(part));
        clear_.emplace_back();
    }
}

double BodyContactFinder::gapBelow(const Bounds& bounds, const Placed& placed, double round) const {
    const Vec3 center = placed.X_WB * bounds.center;
    const Vec3 half = placed.R.cwiseAbs() * bounds.half + Vec3::Constant(margin_);
    const Vec3 around(round, round, 0.0);
    return center.z() - half.z() - terrain_.highest(center - half - around, center + half + around);
}

/// How far any point of a body may move from where it is without touching, by boxes that get
/// smaller; <= 0 where none is known [m].
double BodyContactFinder::clearanceOf(const Placed& placed) const {
    constexpr double kRound = 0.03;       // [m], assumed: a step moves a body by 0.2 mm
    constexpr double kRoundPoint = 0.01;  // [m], assumed
    double least = std::min(gapBelow(placed.part.bounds, placed, kRound), kRound);
    if (least >= kRoundPoint) {
        return least;
    }
    least = kRoundPoint;
    for (const Patch& patch : placed.part.patches) {
        if (gapBelow(patch.bounds, placed, kRoundPoint) >= least) {
            continue;
        }
        for (std::size_t i = patch.first; i < patch.end && least > 0.0; ++i) {
            const BodySample& sample = placed.part.samples[i];
            const Vec3 half = Vec3::Constant(sample.radius);
            least = std::min(least, gapBelow({sample.point, half}, placed, kRoundPoint));
        }
    }
    return least;
}

// A look at the ground round a body serves for many steps, until it has moved as far as that, or,
// where it was too near, far enough for another look.
bool BodyContactFinder::staysClear(std::size_t part, const Placed& placed) {
    constexpr double kLookAgain = 0.002;  // [m], assumed
    Clearance& clear = clear_[part];
    const Eigen::Quaterniond turn = clear.X_WB.rotation.conjugate() * placed.X_WB.rotation;
    const double moved = (placed.X_WB.position - clear.X_WB.position).norm() +
                         2.0 * placed.part.farthest * turn.vec().norm();
    if (moved >= clear.distance) {
        const double gap = clearanceOf(placed);
        clear = {placed.X_WB, std::max(gap, kLookAgain), gap >= kLookAgain};
    }
    return clear.isClear;
}

void BodyContactFinder::touch(std::size_t index, const Placed& placed) {
    const BodySample& sample = placed.part.samples[index];
    const Vec3 p = placed.R * sample.point + placed.X_WB.position;
    const double below = terrain_.heightAt(p.x(), p.y()) - p.z();
    if (std::isnan(below) || (sample.radius == 0.0 && below <= -margin_)) {
        return;
    }
    // The ground straight above or below is no nearer than the nearest.
    double reach = sample.radius + margin_;
    if (sample.radius == 0.0 || below > 0.0) {
        reach = std::max(reach, std::min(std::abs(below), deepest_));
    }
    constexpr double kRounding = 1e-9;
    constexpr double kAnyDirection = std::numbers::pi;
    const Vec3 box = Vec3::Constant(reach + kRounding);
    terrain_.facing(p - box, p + box, Vec3::UnitZ(), kAnyDirection, facets_);
    const auto looksAtBody = [&](const Vec3& normal) {
        bool looks = sample.faceCount == 0;
        for (int k = 0; k < sample.faceCount && !looks; ++k) {
            looks = -normal.dot(placed.R * sample.faces[static_cast<std::size_t>(k)]) > kLooksAt;
        }
        return looks;
    };
    const std::optional<Nearest> ground = nearestOf(facets_, p, looksAtBody);
    if (!ground || ground->distance > reach + kRounding) {
        return;
    }
    // A ball touches an edge with its own surface.
    const bool isInside = ground->height < 0.0;
    const bool isBall = sample.radius > 0.0 && !isInside && ground->distance > kRounding;
    const double depth = isBall ? sample.radius - ground->distance : sample.radius - ground->height;
    if (depth <= -margin_ || (isInside && ground->distance > deepest_)) {
        return;
    }
    const Vec3 normal = isBall ? Vec3((p - ground->point) / ground->distance) : ground->normal;
    touching_.push_back({-1, static_cast<int>(index), ground->point, normal,
                         alongFace(placed.forward, normal), depth, placed.part.body});
}

// The patch that touches is cut into quarters about its middle, along and across the heading, or
// along and up a wall; so a body that rests on something has a contact near each corner of it.
void BodyContactFinder::keepBest(const Placed& placed, bool walls) {
    const Vec3 left = Vec3::UnitZ().cross(placed.forward);
    const auto placeOf = [&](const Contact& c) -> Eigen::Vector2d {
        const Vec3 arm = c.point - placed.X_WB.position;
        if (!walls) {
            return {placed.forward.dot(arm), left.dot(arm)};
        }
        return {Vec3::UnitZ().cross(c.normal).normalized().dot(arm), arm.z()};
    };
    const auto counts = [&](const Contact& c) { return (std::abs(c.normal.z()) < kWall) == walls; };

    Eigen::AlignedBox2d patch;
    for (const Contact& c : touching_) {
        if (counts(c)) {
            patch.extend(placeOf(c));
        }
    }
    if (patch.isEmpty()) {
        return;
    }
    const Eigen::Vector2d middle = patch.center();

    struct Quarter {
        const Contact* best = nullptr;
        double rank = 0.0;
    };

    std::array<Quarter, 4> quarters;
    for (const Contact& c : touching_) {
        if (!counts(c)) {
            continue;
        }
        const Eigen::Vector2d place = placeOf(c) - middle;
        const double rank = c.depth + kOutward * place.lpNorm<1>();
        for (std::size_t k = 0; k < quarters.size(); ++k) {
            const bool here = ((k & 1U) != 0U ? place.x() : -place.x()) > -kOnLine &&
                              ((k & 2U) != 0U ? place.y() : -place.y()) > -kOnLine;
            if (here && (quarters[k].best == nullptr || rank > quarters[k].rank)) {
                quarters[k] = {&c, rank};
            }
        }
    }
    const auto first = static_cast<std::ptrdiff_t>(contacts_.size());
    for (const Quarter& quarter : quarters) {
        const bool isNew =
            quarter.best != nullptr &&
            std::none_of(contacts_.begin() + first, contacts_.end(),
                         [&](const Contact& kept) { return kept.slice == quarter.best->slice; });
        if (isNew) {
            contacts_.push_back(*quarter.best);
        }
    }
}

const std::vector<Contact>& BodyContactFinder::find(const std::vector<Pose>& bodies) {
    contacts_.clear();
    for (std::size_t index = 0; index < parts_.size(); ++index) {
        const Part& part = parts_[index];
        const Pose& X_WB = bodies[static_cast<std::size_t>(part.body)];
        const Mat3 R = X_WB.rotation.toRotationMatrix();
        const Placed placed{part, X_WB, R, levelForward(R)};
        if (staysClear(index, placed)) {
            continue;
        }
        touching_.clear();
        for (const Patch& patch : part.patches) {
            if (gapBelow(patch.bounds, placed, 0.0) < 0.0) {
                for (std::size_t i = patch.first; i < patch.end; ++i) {
                    touch(i, placed);
                }
            }
        }
        keepBest(placed, false);
        keepBest(placed, true);
    }
    return contacts_;
}

}  // namespace simcore::contact
