#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "simcore/mechanism/mechanism.h"
#include "simcore/run/snapshot.h"
#include "simcore/terrain/terrain.h"

namespace osg {
class Camera;
class Group;
class Node;
}  // namespace osg

/// The 3D picture of a rover on its terrain, with OpenSceneGraph, without Qt.
namespace render {

using simcore::Vec3;

/// What is drawn besides rover and terrain.
struct Overlays {
    bool centerOfMass = false;  ///< quartered ball and drop line to the ground
    bool supportPolygon =
        false;                   ///< convex hull of the contact points; red when the CoM is outside
    bool contactForces = false;  ///< arrows of the ground's force on each wheel
    bool jointFreedoms = false;  ///< number of freedoms at each joint
    bool trail = false;          ///< path of the chassis and of the wheels' contacts
    bool grid = true;            ///< metric grid on the terrain: 1 m, and 0.1 m when near
    bool axes = false;           ///< world axes at the origin: x red, y green, z blue
    bool shadow = true;          ///< sun shadow of the rover
    bool operator==(const Overlays&) const = default;
};

/// Where a picture is taken from. World frame [m].
struct CameraPose {
    Vec3 eye = Vec3(-1.5, -1.5, 1.0);
    Vec3 center = Vec3::Zero();
    Vec3 up = Vec3::UnitZ();
    /// Without perspective; what is at `center` is as large as with it.
    bool orthographic = false;
};

/// Standard views of the rover. Front looks at its front; Side at its right side, so that it drives
/// to the right; Overview also shows the ground ahead.
enum class View { Front, Side, Top, Iso, Overview };

/// Vertical field of view of all pictures [deg].
inline constexpr double kFieldOfView = 30.0;

/// What the renderer can afford.
struct Quality {
    int shadowSize = 1024;    ///< side of the shadow map [px]
    int shadowTaps = 1;       ///< 1 or 4 lookups a pixel
    double pixelRatio = 1.0;  ///< device pixels per logical pixel, for lines and labels
    double labelSize = 22.0;  ///< of the numbers at the joints [logical px]
};

/// What a ray hit.
struct Pick {
    int joint = -1;                            ///< nearest pin joint within reach of the ray
    int body = -1;                             ///< body hit
    std::optional<Vec3> point = std::nullopt;  ///< first thing hit, world [m]
};

/// The scene graph of one rover, one terrain and one instant. The picture is a pure function of
/// what was set last; drawing changes nothing. Not thread safe: change and draw it on one thread.
class Scene {
  public:
    Scene();
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// Root of everything that is drawn; owned by the scene.
    osg::Group* root();

    /// Replaces the rover, and shows it in the drawn pose. Clears trail, highlight and counts.
    void setMechanism(const simcore::mechanism::Mechanism& mechanism);
    /// Null: a flat ground at z = 0.
    void setTerrain(std::shared_ptr<const simcore::terrain::Terrain> terrain);
    /// Shows one instant of a run of this mechanism. std::invalid_argument when the number of
    /// bodies or wheels differs. The trail ends at this instant; what was seen beyond it shows
    /// again when the time moves on.
    void setSnapshot(const simcore::run::Snapshot& snapshot);
    /// A second rover, translucent, with no part in picking and overlays; null: none.
    /// std::invalid_argument when the number of bodies differs.
    void setGhost(std::shared_ptr<const simcore::mechanism::Mechanism> mechanism,
                  const std::vector<simcore::Pose>& bodies);
    bool hasGhost() const;
    /// All bodies as designed: the rover frame lies on the world frame.
    void showDrawnPose();

    void setOverlays(const Overlays& overlays);
    const Overlays& overlays() const;
    /// One count per joint of the mechanism, e.g. 6 minus the constraints; empty: none shown.
    void setJointFreedomCounts(std::vector<int> counts);

    /// What is selected; until another rover is shown. std::invalid_argument when there is no such
    /// joint, body or shape.
    struct Highlight {
        std::vector<int> joints;  ///< wear rings
        std::vector<int> bodies;  ///< glow
        int shape = -1;           ///< of each of these bodies, which then does not; -1: all of it
    };

    void highlight(Highlight what);
    /// Rings about several joints and a glow on several bodies, beside what is highlighted, until
    /// marked anew or another rover is shown. std::invalid_argument when there is no such one.
    void mark(std::vector<int> joints, std::vector<int> bodies);
    const std::vector<int>& markedJoints() const;
    const std::vector<int>& markedBodies() const;
    const Highlight& highlighted() const;
    void clearTrail();
    /// The trail of these instants of a run of this mechanism, in the order of time; shown up to
    /// the instant of the next setSnapshot().
    void setTrail(const std::vector<std::shared_ptr<const simcore::run::Snapshot>>& instants);
    /// Sky and fog that go with a dark or a light window.
    void setTheme(bool dark);
    void setQuality(const Quality& quality);
    const Quality& quality() const;

    /// Point to keep in the middle while following: centre of the rover's bounds [m].
    Vec3 focus() const;
    /// Radius of a ball about focus() that holds the rover [m].
    double focusRadius() const;
    /// Camera that shows the whole rover from a standard side; aspect = width / height.
    CameraPose view(View view, double aspect) const;
    /// The same direction as `camera`, at the distance that shows the whole rover.
    CameraPose fitted(const CameraPose& camera, double aspect) const;

    /// First thing on the segment from `start` to `end` [m, world]. A joint counts as hit when the
    /// ray passes within `reach` [m] of it before, or close behind, whatever it hits.
    Pick pick(const Vec3& start, const Vec3& end, double reach) const;

    /// State of the support polygon at the shown instant.
    enum class Support { None, Inside, Outside };
    Support support() const;
    /// World pose of a body as it stands in the scene graph.
    simcore::Pose bodyPose(int body) const;
    int trailLength() const;  ///< number of points up to the shown instant

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Sets view, projection, clear colour and cull settings of a camera that draws a Scene.
void setupCamera(osg::Camera& camera, const CameraPose& pose, int width, int height);

}  // namespace render
