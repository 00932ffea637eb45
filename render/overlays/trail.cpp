#include "render/overlays/trail.h"

#include <algorithm>
#include <iterator>
#include <osg/Geometry>
#include <osg/LineWidth>

#include "render/geometry/mesh_builder.h"
#include "render/look/shaders.h"

namespace render {

namespace {

constexpr double kSpacing = 0.01;  // [m] between recorded points
constexpr double kLift = 0.002;    // [m] above the ground, against flicker

osg::ref_ptr<osg::Geometry> makeLine(const std::vector<std::pair<Vec3, Vec3>>& pieces,
                                     const osg::Vec4ub& color) {
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const auto& [a, b] : pieces) {
        vertices->push_back(toOsg(a));
        vertices->push_back(toOsg(b));
    }
    osg::ref_ptr<osg::Vec4ubArray> colors = new osg::Vec4ubArray;
    colors->push_back(color);
    colors->setNormalize(true);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(vertices);
    geometry->setColorArray(colors, osg::Array::BIND_OVERALL);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, static_cast<int>(vertices->size())));
    return geometry;
}

}  // namespace

Trail::Trail() {
    osg::StateSet& state = *geode_->getOrCreateStateSet();
    state.setAttributeAndModes(makeFlatProgram());
    state.setMode(GL_LINE_SMOOTH, osg::StateAttribute::ON);
    makeBlended(state, 12, true);
}

void Trail::clear() {
    points_.clear();
    shown_ = 0;
}

void Trail::record(const simcore::run::Snapshot& snapshot) {
    auto later =
        std::upper_bound(points_.begin(), points_.end(), snapshot.time,
                         [](double time, const Entry& entry) { return time < entry.time; });
    const auto isHere = [&](const Entry& entry) {
        return (entry.center - snapshot.centerOfMass).norm() < kSpacing;
    };
    if (later != points_.begin() && std::prev(later)->time == snapshot.time &&
        !isHere(*std::prev(later))) {
        // Elsewhere at the same time: another run.
        points_.erase(std::prev(later), points_.end());
        later = points_.end();
    }
    shown_ = static_cast<std::size_t>(std::distance(points_.begin(), later));
    if ((later != points_.begin() && isHere(*std::prev(later))) ||
        (later != points_.end() && isHere(*later))) {
        return;
    }
    Entry entry{snapshot.time, snapshot.centerOfMass, {}, {}};
    for (const auto& wheel : snapshot.wheels) {
        entry.contacts.push_back(wheel.contactPoint);
        entry.touching.push_back(wheel.touching);
    }
    points_.insert(later, std::move(entry));
    ++shown_;
}

void Trail::draw(float width) {
    geode_->removeDrawables(0, geode_->getNumDrawables());
    if (shown_ < 2) {
        return;
    }
    geode_->getOrCreateStateSet()->setAttributeAndModes(new osg::LineWidth(width));
    const Vec3 lift(0.0, 0.0, kLift);
    std::vector<std::pair<Vec3, Vec3>> pieces;
    for (std::size_t i = 1; i < shown_; ++i) {
        pieces.emplace_back(points_[i - 1].center, points_[i].center);
    }
    geode_->addDrawable(makeLine(pieces, osg::Vec4ub(255, 221, 64, 255)));
    for (std::size_t wheel = 0; wheel < points_.front().contacts.size(); ++wheel) {
        pieces.clear();
        for (std::size_t i = 1; i < shown_; ++i) {
            if (points_[i - 1].touching[wheel] && points_[i].touching[wheel]) {
                pieces.emplace_back(points_[i - 1].contacts[wheel] + lift,
                                    points_[i].contacts[wheel] + lift);
            }
        }
        const Rgb color = wheelColor(static_cast<int>(wheel));
        if (!pieces.empty()) {
            geode_->addDrawable(makeLine(pieces, osg::Vec4ub(color.r, color.g, color.b, 215)));
        }
    }
}

}  // namespace render
