#include "tests/bench/peers/mjcf.h"

#include <algorithm>

#include <fmt/format.h>

namespace peers {
namespace {

using simcore::mechanism::Body;
using simcore::mechanism::Mechanism;
using simcore::mechanism::Wheel;

// Gain of the wheels' velocity servos [N m s/rad] (assumed: full torque at 0.3 rad/s of error).
constexpr double kServoGain = 10.0;
// How close to rigid: share of a constraint's force that MuJoCo may leave out, and the depth over
// which it does so [m]. Loops are kept tighter than contacts (assumed; in both near the stiffest
// that MuJoCo's documentation allows).
constexpr const char* kLoopImpedance = "0.999 0.9999 0.0001";
constexpr const char* kContactImpedance = "0.98 0.99 0.0005";
// Ground below the lowest point, so that its prisms have a volume [m].
constexpr double kThickness = 0.5;

std::string text(const Vec3& v) {
    return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

/// For an attribute in double quotes.
std::string escaped(const std::string& name) {
    std::string out;
    for (const char c : name) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

class Writer {
  public:
    Writer(const Mechanism& mechanism, const PeerTree& tree, const HeightGrid& ground,
           const MjcfSettings& settings)
        : mechanism_(mechanism),
          tree_(tree),
          ground_(ground),
          settings_(settings) {}

    std::string write() {
        line("<mujoco model=\"{}\">", escaped(mechanism_.name));
        ++depth_;
        writeOptions();
        writeGround();
        line("<worldbody>");
        ++depth_;
        line(R"(<geom name="{}" type="hfield" hfield="terrain" pos="{} {} {}" contype="1" )"
             R"(conaffinity="0" {}/>)",
             kMjcfGround, 0.5 * (ground_.x0 + ground_.x1()), 0.5 * (ground_.y0 + ground_.y1()),
             ground_.lowest(), contact());
        writeLink(0);
        --depth_;
        line("</worldbody>");
        writeClosures();
        writeActuators();
        --depth_;
        line("</mujoco>");
        return out_;
    }

  private:
    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        out_.append(static_cast<std::size_t>(2 * depth_), ' ');
        fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
        out_ += '\n';
    }

    /// The stiffest that MuJoCo allows, without overshoot.
    std::string solref() const { return fmt::format("solref=\"{} 1\"", 2.0 * settings_.step); }

    std::string contact() const {
        return fmt::format("condim=\"3\" friction=\"{} 0 0\" {} solimp=\"{}\"", settings_.friction,
                           solref(), kContactImpedance);
    }

    void writeOptions() {
        line(R"(<compiler angle="radian" autolimits="true"/>)");
        line(R"(<option timestep="{}" gravity="0 0 {}" integrator="implicit" solver="Newton" )"
             R"(cone="elliptic" iterations="50" tolerance="1e-10" impratio="10"/>)",
             settings_.step, -settings_.gravity);
        line(R"(<size nconmax="1000" njmax="5000"/>)");
    }

    void writeGround() {
        line("<asset>");
        line(R"(  <hfield name="terrain" nrow="{}" ncol="{}" size="{} {} {} {}"/>)", ground_.rows,
             ground_.columns, 0.5 * (ground_.x1() - ground_.x0), 0.5 * (ground_.y1() - ground_.y0),
             elevation(ground_), kThickness);
        line("</asset>");
    }

    void writeLink(int position) {
        const Link& link = tree_.links[static_cast<std::size_t>(position)];
        const Body& body = mechanism_.bodies[static_cast<std::size_t>(link.body)];
        line("<body name=\"{}\">", escaped(body.name));
        ++depth_;
        writeJoint(link);
        const Mat3& I = body.inertia;
        line(R"(<inertial pos="{}" mass="{}" fullinertia="{} {} {} {} {} {}"/>)", text(body.com),
             body.mass, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
        if (link.wheel >= 0) {
            writeWheel(mechanism_.wheels[static_cast<std::size_t>(link.wheel)]);
        }
        for (std::size_t i = 0; i < tree_.links.size(); ++i) {
            if (tree_.links[i].parent == position) {
                writeLink(static_cast<int>(i));
            }
        }
        --depth_;
        line("</body>");
    }

    void writeJoint(const Link& link) {
        if (link.parent < 0) {
            line("<freejoint/>");
            return;
        }
        std::string extra;
        if (link.damping > 0.0) {
            extra += fmt::format(" damping=\"{}\"", link.damping);
        }
        if (link.stiffness > 0.0) {
            extra += fmt::format(" stiffness=\"{}\" springref=\"{}\"", link.stiffness,
                                 link.preload / link.stiffness);
        }
        if (link.stops) {
            extra += fmt::format(" range=\"{} {}\"", link.stops->first, link.stops->second);
        }
        if (link.wheel >= 0) {
            const Wheel& wheel = mechanism_.wheels[static_cast<std::size_t>(link.wheel)];
            extra += fmt::format(" armature=\"{}\"", wheel.rotorInertia);
        }
        line(R"(<joint name="{}" type="hinge" pos="{}" axis="{}"{}/>)", jointName(link),
             text(link.point), text(link.axis), extra);
    }

    std::string jointName(const Link& link) const {
        return escaped(mechanism_.joints[static_cast<std::size_t>(link.joint)].name);
    }

    void writeWheel(const Wheel& wheel) {
        const double half = 0.5 * wheel.width;
        std::string size;
        switch (settings_.wheel) {
            case WheelShape::Ellipsoid:
                size = fmt::format("{} {} {}", wheel.radius, wheel.radius, half);
                break;
            case WheelShape::Cylinder:
                size = fmt::format("{} {}", wheel.radius, half);
                break;
            case WheelShape::Sphere:
                size = fmt::format("{}", wheel.radius);
                break;
        }
        line(R"(<geom name="{}" type="{}" size="{}" pos="{}" zaxis="{}" contype="0" )"
             R"(conaffinity="1" {}/>)",
             escaped(wheel.name), toString(settings_.wheel), size, text(wheel.center),
             text(wheel.axis), contact());
    }

    void writeClosures() {
        if (tree_.closures.empty()) {
            return;
        }
        line("<equality>");
        for (const Closure& closure : tree_.closures) {
            line(R"(  <connect body1="{}" body2="{}" anchor="{}" {} solimp="{}"/>)",
                 bodyName(closure.first), bodyName(closure.second), text(closure.point), solref(),
                 kLoopImpedance);
        }
        line("</equality>");
    }

    std::string bodyName(int position) const {
        const Link& link = tree_.links[static_cast<std::size_t>(position)];
        return escaped(mechanism_.bodies[static_cast<std::size_t>(link.body)].name);
    }

    void writeActuators() {
        line("<actuator>");
        for (std::size_t i = 0; i < mechanism_.wheels.size(); ++i) {
            const Wheel& wheel = mechanism_.wheels[i];
            const auto link =
                std::find_if(tree_.links.begin(), tree_.links.end(),
                             [i](const Link& l) { return l.wheel == static_cast<int>(i); });
            line(R"(  <velocity joint="{}" kv="{}" forcerange="{} {}"/>)", jointName(*link),
                 kServoGain, -wheel.torqueLimit, wheel.torqueLimit);
        }
        line("</actuator>");
    }

    const Mechanism& mechanism_;
    const PeerTree& tree_;
    const HeightGrid& ground_;
    const MjcfSettings& settings_;
    std::string out_;
    int depth_ = 0;
};

}  // namespace

std::string toString(WheelShape shape) {
    switch (shape) {
        case WheelShape::Ellipsoid:
            return "ellipsoid";
        case WheelShape::Cylinder:
            return "cylinder";
        case WheelShape::Sphere:
            break;
    }
    return "sphere";
}

double elevation(const HeightGrid& ground) {
    // Level ground has an elevation, too: MuJoCo wants one above 0.
    constexpr double kLeast = 0.01;
    return std::max(ground.highest() - ground.lowest(), kLeast);
}

std::string mjcfOf(const Mechanism& mechanism, const PeerTree& tree, const HeightGrid& ground,
                   const MjcfSettings& settings) {
    return Writer(mechanism, tree, ground, settings).write();
}

}  // namespace peers
