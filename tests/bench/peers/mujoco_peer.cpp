#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "simcore/dynamics/engine.h"
#include "tests/bench/peers/peer.h"

namespace peers {
namespace {

using simcore::Pose;
using simcore::contact::Contact;
using simcore::mechanism::Mechanism;

struct DeleteModel {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
};

struct DeleteData {
    void operator()(mjData* data) const { mj_deleteData(data); }
};

using Model = std::unique_ptr<mjModel, DeleteModel>;
using Data = std::unique_ptr<mjData, DeleteData>;

Model compiled(const std::string& text) {
    constexpr const char* kFile = "rover.xml";
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    if (mj_makeEmptyFileVFS(files.get(), kFile, static_cast<int>(text.size())) != 0) {
        throw std::runtime_error("MuJoCo has no room for the model");
    }
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), kFile)], text.data(), text.size());
    char error[1000] = "";
    Model model(mj_loadXML(kFile, files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (!model) {
        throw std::runtime_error(fmt::format("MuJoCo refuses the model: {}", error));
    }
    return model;
}

/// That MuJoCo has understood the text as it was meant.
void check(const mjModel& model, const Mechanism& mechanism, const PeerTree& tree) {
    double mass = 0.0;
    for (int i = 1; i < model.nbody; ++i) {
        mass += model.body_mass[i];
    }
    const auto count = [](const auto& things) { return static_cast<int>(things.size()); };
    if (model.nbody != count(mechanism.bodies) + 1 || model.njnt != count(tree.links) ||
        model.neq != count(tree.closures) || model.nu != count(mechanism.wheels) ||
        std::abs(mass - mechanism.mass()) > 1e-9 * mechanism.mass()) {
        throw std::runtime_error(fmt::format(
            "MuJoCo reads another rover: {} bodies of {} kg, {} joints, {} closures, {} motors",
            model.nbody - 1, mass, model.njnt, model.neq, model.nu));
    }
}

class MujocoPeer final : public Peer {
  public:
    explicit MujocoPeer(const PeerWorld& world)
        : mechanism_(world.run.mechanism),
          shape_(world.wheel),
          model_(compiled(mjcfOf(
              mechanism_, world.tree, world.ground,
              {world.run.step, simcore::dynamics::kGravity, world.run.friction, world.wheel}))) {
        check(*model_, mechanism_, world.tree);
        const double low = world.ground.lowest();
        const double range = elevation(world.ground);
        std::transform(world.ground.heights.begin(), world.ground.heights.end(),
                       model_->hfield_data,
                       [&](double height) { return static_cast<float>((height - low) / range); });
        data_.reset(mj_makeData(model_.get()));
        for (const auto& body : mechanism_.bodies) {
            bodies_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, body.name.c_str()));
        }
        wheelOf_.assign(static_cast<std::size_t>(model_->ngeom), -1);
        for (std::size_t i = 0; i < mechanism_.wheels.size(); ++i) {
            const int geom =
                mj_name2id(model_.get(), mjOBJ_GEOM, mechanism_.wheels[i].name.c_str());
            wheelOf_[static_cast<std::size_t>(geom)] = static_cast<int>(i);
        }
    }

    std::string name() const override {
        return fmt::format("MuJoCo {}, {}s", mj_versionString(), toString(shape_));
    }

    void step(std::span<const double> wheelSpeeds) override {
        std::copy(wheelSpeeds.begin(), wheelSpeeds.end(), data_->ctrl);
        mj_step(model_.get(), data_.get());
    }

    void read(Reading& reading) override {
        // A step ends with new coordinates; places still are those that it began with.
        mj_kinematics(model_.get(), data_.get());
        reading.poses.clear();
        for (const int body : bodies_) {
            const mjtNum* p = data_->xpos + 3 * body;
            const mjtNum* q = data_->xquat + 4 * body;
            reading.poses.push_back(
                {Eigen::Quaterniond(q[0], q[1], q[2], q[3]), Vec3(p[0], p[1], p[2])});
        }
        reading.contacts.clear();
        reading.forces.clear();
        for (int i = 0; i < data_->ncon; ++i) {
            addContact(i, reading);
        }
    }

    bool failed() const override {
        return std::any_of(data_->warning, data_->warning + mjNWARNING,
                           [](const mjWarningStat& warning) { return warning.number > 0; });
    }

  private:
    void addContact(int index, Reading& reading) const {
        const mjContact& found = data_->contact[index];
        const int first = wheelOf_[static_cast<std::size_t>(found.geom1)];
        const int second = wheelOf_[static_cast<std::size_t>(found.geom2)];
        // The normal points from the first to the second geom.
        const double toWheel = second >= 0 ? 1.0 : -1.0;
        mjtNum force[6];
        mj_contactForce(model_.get(), data_.get(), index, force);
        const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(found.frame);
        const Vec3 normal = toWheel * frame.row(0).transpose();
        Contact contact;
        contact.wheel = second >= 0 ? second : first;
        contact.normal = normal;
        contact.depth = -found.dist;
        // MuJoCo's point is half way between the surfaces, ours on the ground.
        contact.point =
            Vec3(found.pos[0], found.pos[1], found.pos[2]) + 0.5 * contact.depth * normal;
        reading.contacts.push_back(contact);
        reading.forces.push_back(toWheel * frame.transpose() * Vec3(force[0], force[1], force[2]));
    }

    const Mechanism& mechanism_;
    WheelShape shape_;
    Model model_;
    Data data_;
    std::vector<int> bodies_;   ///< MuJoCo's numbers, mechanism order
    std::vector<int> wheelOf_;  ///< by geom; -1 = none
};

}  // namespace

PeerMaker mujocoMaker() {
    return [](const PeerWorld& world) { return std::make_unique<MujocoPeer>(world); };
}

}  // namespace peers
