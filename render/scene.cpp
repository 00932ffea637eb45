#include "render/scene.h"

#include <algorithm>
#include <cmath>
#include <osg/ColorMask>
#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <stdexcept>

#include "render/geometry/mesh_builder.h"
#include "render/geometry/rover_model.h"
#include "render/geometry/terrain_model.h"
#include "render/look/shaders.h"
#include "render/look/sky.h"
#include "render/look/sun_shadow.h"
#include "render/overlays/badges.h"
#include "render/overlays/overlay_nodes.h"
#include "render/overlays/trail.h"
#include "simcore/dynamics/engine.h"

namespace render {

namespace {

using simcore::Pose;
using simcore::mechanism::Mechanism;
using simcore::run::Snapshot;

constexpr std::size_t kShadedWheels = 8;
// After the solid things, before the overlays (bin 10 and on).
constexpr int kGhostDepthBin = 8;
constexpr int kGhostBin = 9;

osg::Matrixd matrixOf(const Pose& pose) {
    const auto& q = pose.rotation;
    osg::Matrixd matrix = osg::Matrixd::rotate(osg::Quat(q.x(), q.y(), q.z(), q.w()));
    matrix.setTrans(pose.position.x(), pose.position.y(), pose.position.z());
    return matrix;
}

/// The designed rover as an instant: wheels stand where they are lowest.
Snapshot drawnPose(const Mechanism& mechanism) {
    Snapshot snapshot;
    snapshot.bodies.resize(mechanism.bodies.size());
    snapshot.centerOfMass = mechanism.centerOfMass();
    double lowest = 0.0;
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        const double foot = mechanism.wheels[i].center.z() - mechanism.wheels[i].radius;
        lowest = i == 0 ? foot : std::min(lowest, foot);
    }
    for (const auto& wheel : mechanism.wheels) {
        auto& state = snapshot.wheels.emplace_back();
        state.contactPoint = wheel.center - wheel.radius * Vec3::UnitZ();
        state.touching = state.contactPoint.z() < lowest + 1e-3;
    }
    return snapshot;
}

bool contains(const std::vector<int>& indices, int index) {
    return std::find(indices.begin(), indices.end(), index) != indices.end();
}

bool allWithin(const std::vector<int>& indices, std::size_t count) {
    return std::all_of(indices.begin(), indices.end(), [count](int index) {
        return index >= 0 && index < static_cast<int>(count);
    });
}

osg::ref_ptr<osg::MatrixTransform> makeBody(const Mechanism& mechanism, int body) {
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform;
    transform->setDataVariance(osg::Object::DYNAMIC);
    transform->setName(mechanism.bodies[static_cast<std::size_t>(body)].name);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(makeBodyGeometry(mechanism, body));
    transform->addChild(geode);
    return transform;
}

}  // namespace

struct Scene::Impl {
    Mechanism mechanism;
    std::shared_ptr<const simcore::terrain::Terrain> terrain;
    Snapshot snapshot;
    Overlays shown;
    Quality quality;
    RoverBounds bounds;
    std::vector<int> freedomCounts;
    Highlight highlight;
    std::vector<int> markedJoints, markedBodies;

    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<osg::Group> rover = new osg::Group;
    osg::ref_ptr<osg::Group> ground = new osg::Group;
    osg::ref_ptr<osg::Group> overlays = new osg::Group;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> bodies;
    std::shared_ptr<const Mechanism> ghost;
    osg::ref_ptr<osg::Group> ghostRover = new osg::Group;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> ghostBodies;
    std::vector<osg::ref_ptr<osg::Uniform>> highlights;
    SunShadow sun{Quality{}.shadowSize};
    BadgeNode badges;
    Trail trail;
    osg::ref_ptr<osg::Uniform> fogColor, zenithColor, fogCenter, contacts;
    osg::ref_ptr<osg::Node> measured;  ///< ground with the grid

    Impl();
    void attachGhost();
    void buildRover();
    void buildGhost();
    void buildGround();
    void place();
    void buildOverlays();
    void applyHighlights();
    void applySwitches();
    Vec3 focus() const;
    double groundBelow(const Vec3& p) const;
};

Scene::Impl::Impl()
    : fogColor(new osg::Uniform(uniform::kFogColor, osg::Vec3())),
      zenithColor(new osg::Uniform(uniform::kZenithColor, osg::Vec3())),
      fogCenter(new osg::Uniform(uniform::kFogCenter, osg::Vec3())),
      contacts(new osg::Uniform(osg::Uniform::FLOAT_VEC4, uniform::kGroundContact, kShadedWheels)) {
    osg::StateSet& state = *root->getOrCreateStateSet();
    state.setAttributeAndModes(makeSurfaceProgram());
    state.setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state.addUniform(new osg::Uniform(uniform::kSunDirection, sunDirection()));
    for (osg::Uniform* value : {fogColor.get(), zenithColor.get(), fogCenter.get()}) {
        state.addUniform(value);
    }
    state.addUniform(new osg::Uniform(uniform::kHighlight, 0.0F));
    sun.attach(state);

    osg::StateSet& soil = *ground->getOrCreateStateSet();
    soil.setDefine("TERRAIN");
    soil.setTextureAttribute(kNoiseUnit, makeNoiseTexture());
    soil.addUniform(new osg::Uniform(uniform::kNoise, kNoiseUnit));
    soil.addUniform(contacts);

    sun.camera()->addChild(rover);
    root->addChild(sun.camera());
    root->addChild(ground);
    root->addChild(rover);
    attachGhost();
    root->addChild(overlays);
    root->addChild(makeSky());
}

void Scene::Impl::attachGhost() {
    // Its depth first, so that only what is in front shows through, and not all parts at once.
    osg::ref_ptr<osg::Group> depth = new osg::Group;
    depth->getOrCreateStateSet()->setAttribute(new osg::ColorMask(false, false, false, false));
    depth->getOrCreateStateSet()->setRenderBinDetails(kGhostDepthBin, "RenderBin");
    osg::ref_ptr<osg::Group> color = new osg::Group;
    color->getOrCreateStateSet()->setDefine("GHOST");
    makeBlended(*color->getOrCreateStateSet(), kGhostBin, true);
    for (const osg::ref_ptr<osg::Group>& pass : {depth, color}) {
        pass->addChild(ghostRover);
        root->addChild(pass);
    }
}

void Scene::Impl::buildGhost() {
    ghostRover->removeChildren(0, ghostRover->getNumChildren());
    ghostBodies.clear();
    for (std::size_t i = 0; ghost && i < ghost->bodies.size(); ++i) {
        ghostBodies.push_back(makeBody(*ghost, static_cast<int>(i)));
        ghostRover->addChild(ghostBodies.back());
    }
}

void Scene::Impl::buildRover() {
    rover->removeChildren(0, rover->getNumChildren());
    bodies.clear();
    highlights.clear();
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        const osg::ref_ptr<osg::MatrixTransform> transform =
            makeBody(mechanism, static_cast<int>(i));
        highlights.emplace_back(new osg::Uniform(uniform::kHighlight, 0.0F));
        transform->getOrCreateStateSet()->addUniform(highlights.back());
        rover->addChild(transform);
        bodies.push_back(transform);
    }
    bounds = boundsOf(mechanism);
}

void Scene::Impl::buildGround() {
    ground->removeChildren(0, ground->getNumChildren());
    const Ground made = makeGround(terrain.get());
    ground->addChild(made.root);
    measured = made.measured;
    applySwitches();
}

void Scene::Impl::applySwitches() {
    sun.setEnabled(*root->getOrCreateStateSet(), shown.shadow, quality.shadowTaps > 1);
    if (measured != nullptr) {
        osg::StateSet& state = *measured->getOrCreateStateSet();
        if (shown.grid) {
            state.setDefine("GRID");
        } else {
            state.removeDefine("GRID");
        }
    }
}

Vec3 Scene::Impl::focus() const {
    if (snapshot.bodies.empty()) {
        return bounds.center;
    }
    return snapshot.bodies[static_cast<std::size_t>(mechanism.chassis)] * bounds.center;
}

double Scene::Impl::groundBelow(const Vec3& p) const {
    const double height = terrain != nullptr ? terrain->heightAt(p.x(), p.y()) : 0.0;
    return std::isfinite(height) ? height : 0.0;
}

void Scene::Impl::place() {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i]->setMatrix(matrixOf(snapshot.bodies[i]));
    }
    const Vec3 middle = focus();
    fogCenter->set(toOsg(middle));
    sun.cover(middle, 1.5 * bounds.radius);
    for (std::size_t i = 0; i < kShadedWheels; ++i) {
        osg::Vec4 spot(0.0F, 0.0F, -1e6F, 1.0F);  // nowhere
        if (i < mechanism.wheels.size()) {
            const auto& wheel = mechanism.wheels[i];
            const Vec3 center =
                snapshot.bodies[static_cast<std::size_t>(wheel.body)] * wheel.center;
            spot = osg::Vec4(toOsg(center - 0.75 * wheel.radius * Vec3::UnitZ()),
                             static_cast<float>(0.85 * wheel.radius));
        }
        contacts->setElement(static_cast<unsigned>(i), spot);
    }
    buildOverlays();
}

void Scene::Impl::applyHighlights() {
    for (std::size_t i = 0; i < highlights.size(); ++i) {
        const bool marked = contains(markedBodies, static_cast<int>(i));
        const bool whole = highlight.shape < 0 && contains(highlight.bodies, static_cast<int>(i));
        highlights[i]->set(marked || whole ? 1.0F : 0.0F);
    }
}

void Scene::Impl::buildOverlays() {
    overlays->removeChildren(0, overlays->getNumChildren());
    const auto add = [this](const char* name, const osg::ref_ptr<osg::Node>& node) {
        if (node != nullptr) {
            node->setName(name);
            overlays->addChild(node);
        }
    };
    const double size = bounds.radius;
    const float pixels = static_cast<float>(quality.pixelRatio);
    if (shown.axes) {
        add("axes", makeAxes(0.5 * size));
    }
    if (shown.trail) {
        trail.draw(2.5F * pixels);
        add("trail", trail.node());
    }
    if (shown.supportPolygon) {
        add("support polygon", makeSupportPolygon(snapshot, supportOf(snapshot)));
    }
    if (shown.contactForces && !mechanism.wheels.empty()) {
        const double wheelLoad = mechanism.mass() * simcore::dynamics::kGravity /
                                 static_cast<double>(mechanism.wheels.size());
        add("contact forces",
            makeForces(snapshot, 0.42 * size / std::max(wheelLoad, 1e-6), 0.022 * size));
    }
    if (shown.centerOfMass) {
        add("centre of mass", makeCenterOfMass(snapshot.centerOfMass,
                                               groundBelow(snapshot.centerOfMass), 0.055 * size));
    }
    const auto jointPlace = [this](std::size_t i) {
        const auto& joint = mechanism.joints[i];
        return Vec3(snapshot.bodies[static_cast<std::size_t>(joint.first)] * joint.point);
    };
    const auto ring = [&](const char* name, int index, double radius) {
        const auto i = static_cast<std::size_t>(index);
        const auto& joint = mechanism.joints[i];
        const Pose& carrier = snapshot.bodies[static_cast<std::size_t>(joint.first)];
        add(name, makeRing(jointPlace(i), carrier.rotation * joint.axis, radius));
    };
    for (const int joint : markedJoints) {
        ring("marked joint", joint, 0.055 * size);
    }
    for (const int joint : highlight.joints) {
        ring("highlighted joint", joint, 0.09 * size);
    }
    for (std::size_t i = 0; highlight.shape >= 0 && i < highlight.bodies.size(); ++i) {
        const auto body = static_cast<std::size_t>(highlight.bodies[i]);
        add("highlighted shape",
            makeShapeMark(mechanism.bodies[body].shapes[static_cast<std::size_t>(highlight.shape)],
                          matrixOf(snapshot.bodies[body])));
    }
    std::vector<Badge> labels;
    if (shown.jointFreedoms && freedomCounts.size() == mechanism.joints.size()) {
        for (std::size_t i = 0; i < freedomCounts.size(); ++i) {
            labels.push_back({jointPlace(i), freedomCounts[i]});
        }
    }
    badges.set(labels, static_cast<float>(quality.labelSize) * pixels);
    add("joint freedoms", badges.node());
}

Scene::Scene() : impl_(std::make_unique<Impl>()) {
    setTheme(false);
    impl_->buildGround();
    impl_->place();
}

Scene::~Scene() = default;

osg::Group* Scene::root() {
    return impl_->root;
}

void Scene::setMechanism(const Mechanism& mechanism) {
    impl_->mechanism = mechanism;
    impl_->freedomCounts.clear();
    impl_->highlight = {};
    impl_->markedJoints.clear();
    impl_->markedBodies.clear();
    impl_->trail.clear();
    impl_->buildRover();
    showDrawnPose();
}

void Scene::setTerrain(std::shared_ptr<const simcore::terrain::Terrain> terrain) {
    impl_->terrain = std::move(terrain);
    impl_->trail.clear();
    impl_->buildGround();
    impl_->buildOverlays();
}

void Scene::setSnapshot(const Snapshot& snapshot) {
    if (snapshot.bodies.size() != impl_->mechanism.bodies.size() ||
        snapshot.wheels.size() != impl_->mechanism.wheels.size()) {
        throw std::invalid_argument("The snapshot is of another mechanism.");
    }
    impl_->snapshot = snapshot;
    impl_->trail.record(snapshot);
    impl_->place();
}

void Scene::setGhost(std::shared_ptr<const Mechanism> mechanism, const std::vector<Pose>& bodies) {
    if (mechanism != nullptr && mechanism->bodies.size() != bodies.size()) {
        throw std::invalid_argument("The ghost's poses are of another mechanism.");
    }
    if (mechanism != impl_->ghost) {
        impl_->ghost = std::move(mechanism);
        impl_->buildGhost();
    }
    for (std::size_t i = 0; i < impl_->ghostBodies.size(); ++i) {
        impl_->ghostBodies[i]->setMatrix(matrixOf(bodies[i]));
    }
}

bool Scene::hasGhost() const {
    return impl_->ghost != nullptr;
}

void Scene::showDrawnPose() {
    impl_->snapshot = drawnPose(impl_->mechanism);
    impl_->place();
}

void Scene::setOverlays(const Overlays& overlays) {
    impl_->shown = overlays;
    impl_->applySwitches();
    impl_->buildOverlays();
}

const Overlays& Scene::overlays() const {
    return impl_->shown;
}

void Scene::setJointFreedomCounts(std::vector<int> counts) {
    if (!counts.empty() && counts.size() != impl_->mechanism.joints.size()) {
        throw std::invalid_argument("One count per joint is needed.");
    }
    impl_->freedomCounts = std::move(counts);
    impl_->buildOverlays();
}

void Scene::highlight(Highlight what) {
    const auto& bodies = impl_->mechanism.bodies;
    const auto hasShape = [&](int body) {
        return what.shape < static_cast<int>(bodies[static_cast<std::size_t>(body)].shapes.size());
    };
    if (!allWithin(what.joints, impl_->mechanism.joints.size()) ||
        !allWithin(what.bodies, bodies.size()) ||
        !std::all_of(what.bodies.begin(), what.bodies.end(), hasShape)) {
        throw std::invalid_argument("There is no such joint, body or shape.");
    }
    impl_->highlight = std::move(what);
    impl_->applyHighlights();
    impl_->buildOverlays();
}

void Scene::mark(std::vector<int> joints, std::vector<int> bodies) {
    if (!allWithin(joints, impl_->mechanism.joints.size()) ||
        !allWithin(bodies, impl_->bodies.size())) {
        throw std::invalid_argument("There is no such joint or body.");
    }
    impl_->markedJoints = std::move(joints);
    impl_->markedBodies = std::move(bodies);
    impl_->applyHighlights();
    impl_->buildOverlays();
}

const std::vector<int>& Scene::markedJoints() const {
    return impl_->markedJoints;
}

const std::vector<int>& Scene::markedBodies() const {
    return impl_->markedBodies;
}

const Scene::Highlight& Scene::highlighted() const {
    return impl_->highlight;
}

void Scene::clearTrail() {
    impl_->trail.clear();
    impl_->buildOverlays();
}

void Scene::setTrail(const std::vector<std::shared_ptr<const Snapshot>>& instants) {
    impl_->trail.clear();
    for (const auto& instant : instants) {
        impl_->trail.record(*instant);
    }
}

void Scene::setTheme(bool dark) {
    impl_->fogColor->set(dark ? osg::Vec3(0.050F, 0.060F, 0.078F) : osg::Vec3(0.62F, 0.56F, 0.48F));
    impl_->zenithColor->set(dark ? osg::Vec3(0.010F, 0.014F, 0.024F)
                                 : osg::Vec3(0.16F, 0.27F, 0.44F));
}

const Quality& Scene::quality() const {
    return impl_->quality;
}

void Scene::setQuality(const Quality& quality) {
    impl_->quality = quality;
    impl_->sun.resize(quality.shadowSize);
    impl_->applySwitches();
    impl_->place();
}

Vec3 Scene::focus() const {
    return impl_->focus();
}

double Scene::focusRadius() const {
    return impl_->bounds.radius;
}

Scene::Support Scene::support() const {
    return supportOf(impl_->snapshot);
}

int Scene::trailLength() const {
    return impl_->trail.length();
}

Pose Scene::bodyPose(int body) const {
    const osg::Matrixd& matrix = impl_->bodies.at(static_cast<std::size_t>(body))->getMatrix();
    const osg::Quat q = matrix.getRotate();
    const osg::Vec3d p = matrix.getTrans();
    return {Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()), Vec3(p.x(), p.y(), p.z())};
}

Pick Scene::pick(const Vec3& start, const Vec3& end, double reach) const {
    Pick result;
    osg::ref_ptr<osgUtil::LineSegmentIntersector> ray = new osgUtil::LineSegmentIntersector(
        osg::Vec3d(start.x(), start.y(), start.z()), osg::Vec3d(end.x(), end.y(), end.z()));
    osgUtil::IntersectionVisitor visitor(ray);
    impl_->rover->accept(visitor);
    impl_->ground->accept(visitor);
    const Vec3 way = (end - start).normalized();
    double depth = (end - start).norm();
    if (ray->containsIntersections()) {
        const auto& hit = ray->getFirstIntersection();
        const osg::Vec3d point = hit.getWorldIntersectPoint();
        result.point = Vec3(point.x(), point.y(), point.z());
        depth = (*result.point - start).norm();
        for (std::size_t i = 0; i < impl_->bodies.size(); ++i) {
            const osg::NodePath& path = hit.nodePath;
            if (std::find(path.begin(), path.end(), impl_->bodies[i].get()) != path.end()) {
                result.body = static_cast<int>(i);
            }
        }
    }
    double nearest = reach;
    for (std::size_t i = 0; i < impl_->mechanism.joints.size(); ++i) {
        const auto& joint = impl_->mechanism.joints[i];
        const Vec3 place =
            impl_->snapshot.bodies[static_cast<std::size_t>(joint.first)] * joint.point;
        const double along = (place - start).dot(way);
        const double aside = (place - start - along * way).norm();
        // Pins lie inside the links they join: somewhat behind the surface still counts.
        if (along > 0.0 && along < depth + 0.2 * impl_->bounds.radius && aside < nearest) {
            nearest = aside;
            result.joint = static_cast<int>(i);
        }
    }
    return result;
}

}  // namespace render
