#pragma once

#include <array>
#include <limits>
#include <vector>

#include "simcore/contact/wheel_contact.h"
#include "simcore/mechanism/mechanism.h"
#include "simcore/terrain/terrain.h"

/// Where bodies that are no wheels touch the ground: chassis, forks, links, boxes on top.
namespace simcore::contact {

/// A place of a body that can touch, in the body's frame (at the drawn pose the rover's) [m].
struct BodySample {
    Vec3 point = Vec3::Zero();
    double radius = 0.0;  ///< of a ball round the point; 0: the point itself
    /// Unit outward normals of the faces that meet in the point: one on a face, two on an edge,
    /// three in a corner, none of a ball, which touches in any direction.
    std::array<Vec3, 3> faces{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    int faceCount = 0;
};

/// Sample points of a shape's surface: corners, edges and faces of boxes and bars, rims, sides and
/// ends of cylinders, no further apart than 30 mm; of a sphere its ball.
std::vector<BodySample> samplesOf(const mechanism::Shape& shape);

/// Finds the contacts of every body that is neither fixed nor a wheel's. A body touches with sample
/// points of its drawn shapes; a body without shapes touches nothing. A point that is under ground
/// touches the nearest face of the ground that looks at one of its own faces.
class BodyContactFinder {
  public:
    /// Deeper points are left out [m]: nothing is thrown out of a wall that it did not drive into.
    static constexpr double kDeepest = 0.05;

    /// @param margin   contacts are reported from this far before touching [m]
    /// @param deepest  deeper points do not count [m]
    BodyContactFinder(const mechanism::Mechanism& mechanism, const terrain::Terrain& terrain,
                      double margin = 0.0, double deepest = kDeepest);

    /// Contacts at the given body poses X_WB, ordered by body; `Contact::slice` is the sample's
    /// index in its body, `Contact::forward` the body's heading along the ground. Of each body at
    /// most four on ground that it can rest on and four on walls (steeper than 45 deg): the deepest
    /// of each quarter of the patch that touches. Deterministic, and mirrored where poses and
    /// ground are.
    const std::vector<Contact>& find(const std::vector<Pose>& bodies);

  private:
    /// A box round a body or a shape, in the body's frame.
    struct Bounds {
        Vec3 center = Vec3::Zero();
        Vec3 half = Vec3::Zero();
    };

    /// The samples of one shape: a range of those of its body.
    struct Patch {
        Bounds bounds;
        std::size_t first = 0;
        std::size_t end = 0;
    };

    struct Part {
        int body = -1;
        double farthest = 0.0;  ///< of its points from the body's origin [m]
        Bounds bounds;
        std::vector<Patch> patches;
        std::vector<BodySample> samples;
    };

    /// Where a body was when its distance from the ground was looked at, and how far any point of
    /// it may move from there before it is looked at again.
    struct Clearance {
        Pose X_WB;
        double distance = 0.0;  ///< [m]
        bool isClear = false;   ///< it touches nothing until then
    };

    /// A body as it stands in a step.
    struct Placed {
        const Part& part;
        Pose X_WB;
        Mat3 R;
        Vec3 forward;  ///< unit, level
    };

    void addPart(int body);
    /// From the ground up to a box that is `round` wider on all sides, < 0 where it may touch [m].
    double gapBelow(const Bounds& bounds, const Placed& placed, double round) const;
    double clearanceOf(const Placed& placed) const;
    bool staysClear(std::size_t part, const Placed& placed);
    void touch(std::size_t sample, const Placed& placed);
    void keepBest(const Placed& placed, bool walls);

    const mechanism::Mechanism& mechanism_;
    const terrain::Terrain& terrain_;
    double margin_;
    double deepest_;
    std::vector<Part> parts_;
    std::vector<Clearance> clear_;  ///< of the parts
    std::vector<terrain::Facet> facets_;
    std::vector<Contact> touching_;  ///< all of one body
    std::vector<Contact> contacts_;
};

}  // namespace simcore::contact
