#include <algorithm>

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "simcore/dynamics/engine.h"
#include "tests/bench/peers/peer.h"

namespace peers {
namespace {

using simcore::Pose;
using simcore::contact::Contact;
using simcore::mechanism::Mechanism;
using simcore::mechanism::Wheel;

// Passes of the projected Gauss-Seidel solver a step, and its compliance [-] (assumed: ten times
// the default passes, for the loops).
constexpr int kPasses = 100;
constexpr double kCompliance = 1e-9;
// Share of a contact's depth that a step takes back (Bullet's default).
constexpr double kErrorReduction = 0.2;
// Bullet rounds the edges of a cylinder by this much [m].
constexpr double kCylinderMargin = 0.002;

btVector3 toBullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

Vec3 fromBullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

btQuaternion toBullet(const Eigen::Quaterniond& q) {
    return {q.x(), q.y(), q.z(), q.w()};
}

/// A body's frame in Bullet: in its centre of mass, along its principal axes.
struct PrincipalFrame {
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();  ///< in rover axes, drawn pose
    Vec3 com = Vec3::Zero();                                   ///< rover frame, drawn pose [m]
    Vec3 moments = Vec3::Zero();                               ///< [kg m^2]
};

PrincipalFrame principalFrame(const Mechanism& mechanism, int index) {
    const auto body = static_cast<std::size_t>(index);
    const Mat3 inertia = mechanism.inertiaWithRotor(body);
    PrincipalFrame frame;
    frame.com = mechanism.bodies[body].com;
    frame.moments = inertia.diagonal();
    if (!inertia.isDiagonal()) {
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
        Mat3 axes = solver.eigenvectors();
        axes.col(2) = axes.col(0).cross(axes.col(1));  // right-handed
        frame.axes = Eigen::Quaterniond(axes);
        frame.moments = solver.eigenvalues();
    }
    return frame;
}

/// A wheel of the given shape, its axis along y.
std::unique_ptr<btConvexShape> wheelShape(const Wheel& wheel, WheelShape shape) {
    if (shape != WheelShape::Cylinder) {
        return std::make_unique<btSphereShape>(wheel.radius);
    }
    auto cylinder =
        std::make_unique<btCylinderShape>(btVector3(wheel.radius, 0.5 * wheel.width, wheel.radius));
    cylinder->setMargin(kCylinderMargin);
    return cylinder;
}

class BulletPeer final : public Peer {
  public:
    explicit BulletPeer(const PeerWorld& world)
        : world_(world),
          mechanism_(world.run.mechanism),
          dispatcher_(&configuration_),
          dynamics_(&dispatcher_, &broadphase_, &solver_, &configuration_),
          field_(world.ground.columns, world.ground.rows, world.ground.heights.data(),
                 world.ground.lowest() - kSpare, world.ground.highest() + kSpare, 2, false),
          rover_(static_cast<int>(world.tree.links.size()) - 1, rootMass(), rootInertia(), false,
                 false) {
        dynamics_.setGravity({0.0, 0.0, -simcore::dynamics::kGravity});
        btContactSolverInfo& info = dynamics_.getSolverInfo();
        info.m_numIterations = kPasses;
        info.m_globalCfm = kCompliance;
        info.m_erp2 = kErrorReduction;
        info.m_linearSlop = 0.0;
        info.m_minimumSolverBatchSize = 1;
        addGround();
        addLinks();
        addColliders();
        addConstraints();
    }

    ~BulletPeer() override {
        for (const auto& constraint : constraints_) {
            dynamics_.removeMultiBodyConstraint(constraint.get());
        }
        dynamics_.removeMultiBody(&rover_);
        for (const auto& collider : colliders_) {
            dynamics_.removeCollisionObject(collider.get());
        }
        dynamics_.removeCollisionObject(&ground_);
    }

    BulletPeer(const BulletPeer&) = delete;
    BulletPeer& operator=(const BulletPeer&) = delete;

    std::string name() const override {
        const int version = btGetVersion();
        return fmt::format("Bullet {}.{}, {}s", version / 100, version % 100, toString(shape()));
    }

    void step(std::span<const double> wheelSpeeds) override {
        for (std::size_t i = 0; i < motors_.size(); ++i) {
            motors_[i]->setVelocityTarget(wheelSpeeds[i]);
        }
        for (std::size_t i = 1; i < world_.tree.links.size(); ++i) {
            const Link& link = world_.tree.links[i];
            if (link.preload != 0.0 || link.stiffness > 0.0 || link.damping > 0.0) {
                const int at = static_cast<int>(i) - 1;
                rover_.addJointTorque(at, link.preload - link.stiffness * rover_.getJointPos(at) -
                                              link.damping * rover_.getJointVel(at));
            }
        }
        dynamics_.stepSimulation(world_.run.step, 0);
    }

    void read(Reading& reading) override {
        reading.poses.resize(mechanism_.bodies.size());
        for (std::size_t i = 0; i < world_.tree.links.size(); ++i) {
            reading.poses[static_cast<std::size_t>(world_.tree.links[i].body)] = pose(i);
        }
        reading.contacts.clear();
        reading.forces.clear();
        for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
            const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
            for (int k = 0; k < manifold.getNumContacts(); ++k) {
                addContact(manifold, manifold.getContactPoint(k), reading);
            }
        }
    }

    bool failed() const override { return false; }

  private:
    // Height above and below the ground that its bounding box has to spare [m].
    static constexpr double kSpare = 0.1;

    /// Bullet has no ellipsoid.
    WheelShape shape() const {
        return world_.wheel == WheelShape::Cylinder ? WheelShape::Cylinder : WheelShape::Sphere;
    }

    PrincipalFrame frameOf(std::size_t position) const {
        return principalFrame(mechanism_, world_.tree.links[position].body);
    }

    double rootMass() const {
        return mechanism_.bodies[static_cast<std::size_t>(world_.tree.links[0].body)].mass;
    }

    btVector3 rootInertia() const { return toBullet(frameOf(0).moments); }

    void addGround() {
        const HeightGrid& grid = world_.ground;
        field_.setLocalScaling({grid.cell, grid.cell, 1.0});
        field_.setMargin(0.0);
        field_.buildAccelerator();
        btTransform placed = btTransform::getIdentity();
        placed.setOrigin({0.5 * (grid.x0 + grid.x1()), 0.5 * (grid.y0 + grid.y1()),
                          0.5 * (grid.lowest() + grid.highest())});
        ground_.setCollisionShape(&field_);
        ground_.setWorldTransform(placed);
        ground_.setFriction(1.0);  // Bullet multiplies those of the two bodies
        dynamics_.addCollisionObject(&ground_, btBroadphaseProxy::StaticFilter,
                                     btBroadphaseProxy::DefaultFilter);
    }

    void addLinks() {
        const auto count = world_.tree.links.size();
        for (std::size_t i = 0; i < count; ++i) {
            frames_.push_back(frameOf(i));
        }
        rover_.setBasePos(toBullet(frames_[0].com));
        rover_.setWorldToBaseRot(toBullet(frames_[0].axes.conjugate()));
        for (std::size_t i = 1; i < count; ++i) {
            const Link& link = world_.tree.links[i];
            const PrincipalFrame& own = frames_[i];
            const PrincipalFrame& parent = frames_[static_cast<std::size_t>(link.parent)];
            const Eigen::Quaterniond toOwn = own.axes.conjugate();
            rover_.setupRevolute(static_cast<int>(i) - 1,
                                 mechanism_.bodies[static_cast<std::size_t>(link.body)].mass,
                                 toBullet(own.moments), link.parent - 1,
                                 toBullet(toOwn * parent.axes), toBullet(toOwn * link.axis),
                                 toBullet(parent.axes.conjugate() * (link.point - parent.com)),
                                 toBullet(toOwn * (own.com - link.point)), true);
        }
        rover_.finalizeMultiDof();
        rover_.setCanSleep(false);
        rover_.setLinearDamping(0.0);
        rover_.setAngularDamping(0.0);
        rover_.setHasSelfCollision(false);
        rover_.setUseGyroTerm(true);
        dynamics_.addMultiBody(&rover_);
    }

    // A constraint on a link without a collider belongs to no island and is left out in silence, so
    // every link has one; only wheels meet the ground.
    void addColliders() {
        for (std::size_t i = 0; i < world_.tree.links.size(); ++i) {
            const Link& link = world_.tree.links[i];
            const int at = static_cast<int>(i) - 1;
            auto collider = std::make_unique<btMultiBodyLinkCollider>(&rover_, at);
            collider->setCollisionShape(link.wheel < 0 ? &nothing_ : addWheelShape(i));
            collider->setFriction(world_.run.friction);
            collider->setWorldTransform(
                btTransform(toBullet(frames_[i].axes), toBullet(frames_[i].com)));
            if (at < 0) {
                rover_.setBaseCollider(collider.get());
            } else {
                rover_.getLink(at).m_collider = collider.get();
            }
            dynamics_.addCollisionObject(collider.get(), btBroadphaseProxy::DefaultFilter,
                                         link.wheel < 0 ? 0 : btBroadphaseProxy::StaticFilter);
            colliders_.push_back(std::move(collider));
        }
    }

    btCollisionShape* addWheelShape(std::size_t position) {
        const Wheel& wheel =
            mechanism_.wheels[static_cast<std::size_t>(world_.tree.links[position].wheel)];
        const PrincipalFrame& frame = frames_[position];
        const Eigen::Quaterniond toOwn = frame.axes.conjugate();
        const Vec3 center = toOwn * (wheel.center - frame.com);
        const auto turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), toOwn * wheel.axis);
        shapes_.push_back(wheelShape(wheel, shape()));
        btCollisionShape* bare = shapes_.back().get();
        constexpr double kSame = 1e-12;
        if (center.norm() < kSame && turn.vec().norm() < kSame) {
            return bare;  // a compound costs time
        }
        auto placed = std::make_unique<btCompoundShape>();
        placed->addChildShape(btTransform(toBullet(turn), toBullet(center)), bare);
        shapes_.push_back(std::move(placed));
        return shapes_.back().get();
    }

    void addConstraints() {
        motors_.resize(mechanism_.wheels.size());
        for (std::size_t i = 1; i < world_.tree.links.size(); ++i) {
            const Link& link = world_.tree.links[i];
            const int at = static_cast<int>(i) - 1;
            if (link.wheel >= 0) {
                const Wheel& wheel = mechanism_.wheels[static_cast<std::size_t>(link.wheel)];
                motors_[static_cast<std::size_t>(link.wheel)] = add<btMultiBodyJointMotor>(
                    &rover_, at, 0.0, wheel.torqueLimit * world_.run.step);
            }
            if (link.stops) {
                add<btMultiBodyJointLimitConstraint>(&rover_, at, link.stops->first,
                                                     link.stops->second);
            }
        }
        for (const Closure& closure : world_.tree.closures) {
            auto* point = add<btMultiBodyPoint2Point>(
                &rover_, closure.first - 1, &rover_, closure.second - 1,
                inFrame(closure.first, closure.point), inFrame(closure.second, closure.point));
            constexpr double kAnyImpulse = 1e6;  // [N s]
            point->setMaxAppliedImpulse(kAnyImpulse);
        }
    }

    template <class Constraint, class... Args>
    Constraint* add(Args&&... args) {
        auto made = std::make_unique<Constraint>(std::forward<Args>(args)...);
        Constraint* constraint = made.get();
        dynamics_.addMultiBodyConstraint(constraint);
        constraints_.push_back(std::move(made));
        return constraint;
    }

    btVector3 inFrame(int position, const Vec3& point) const {
        const PrincipalFrame& frame = frames_[static_cast<std::size_t>(position)];
        return toBullet(frame.axes.conjugate() * (point - frame.com));
    }

    Pose pose(std::size_t position) const {
        const int at = static_cast<int>(position) - 1;
        const btMatrix3x3 turn = rover_.localFrameToWorld(at, btMatrix3x3::getIdentity());
        const btVector3 com = rover_.localPosToWorld(at, {0.0, 0.0, 0.0});
        btQuaternion q;
        turn.getRotation(q);
        Pose pose;
        pose.rotation =
            Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()) * frames_[position].axes.conjugate();
        pose.position = fromBullet(com) - pose.rotation * frames_[position].com;
        return pose;
    }

    /// The wheel that a collider is; -1 = none.
    int wheelOf(const btCollisionObject* object) const {
        const auto* collider = btMultiBodyLinkCollider::upcast(object);
        return collider == nullptr
                   ? -1
                   : world_.tree.links[static_cast<std::size_t>(collider->m_link + 1)].wheel;
    }

    void addContact(const btPersistentManifold& manifold, const btManifoldPoint& found,
                    Reading& reading) const {
        const int wheelA = wheelOf(manifold.getBody0());
        const bool wheelIsA = wheelA >= 0;
        // The normal points from B to A, and so do the forces on A.
        const double toWheel = wheelIsA ? 1.0 : -1.0;
        Contact contact;
        contact.wheel = wheelIsA ? wheelA : wheelOf(manifold.getBody1());
        contact.normal = toWheel * fromBullet(found.m_normalWorldOnB);
        contact.depth = -found.getDistance();
        contact.point =
            fromBullet(wheelIsA ? found.getPositionWorldOnB() : found.getPositionWorldOnA());
        const btVector3 impulse = found.m_appliedImpulse * found.m_normalWorldOnB +
                                  found.m_appliedImpulseLateral1 * found.m_lateralFrictionDir1 +
                                  found.m_appliedImpulseLateral2 * found.m_lateralFrictionDir2;
        reading.contacts.push_back(contact);
        reading.forces.push_back(toWheel / world_.run.step * fromBullet(impulse));
    }

    const PeerWorld& world_;
    const Mechanism& mechanism_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btMultiBodyConstraintSolver solver_;
    btMultiBodyDynamicsWorld dynamics_;
    btHeightfieldTerrainShape field_;
    btCollisionObject ground_;
    btMultiBody rover_;
    btEmptyShape nothing_;
    std::vector<PrincipalFrame> frames_;  ///< tree order
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
    std::vector<std::unique_ptr<btMultiBodyConstraint>> constraints_;
    std::vector<btMultiBodyJointMotor*> motors_;  ///< mechanism order
};

}  // namespace

PeerMaker bulletMaker() {
    return [](const PeerWorld& world) { return std::make_unique<BulletPeer>(world); };
}

}  // namespace peers
