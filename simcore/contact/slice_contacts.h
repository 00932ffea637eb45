#pragma once

#include <optional>
#include <vector>

#include "simcore/terrain/terrain.h"

/// Where one disc of a wheel touches the section of the ground with its plane.
namespace simcore::contact {

/// A touching point, in the plane's coordinates; the disc's centre is at 0.
struct SliceContact {
    Eigen::Vector2d point;  ///< on the ground [m]
    Vec3 normal;            ///< unit, ground to wheel, world
    double depth;           ///< penetration along the normal [m], > 0 inside
    /// Cosine of the angle by which the section turns at a corner; 1 on a face, -1 where the ground
    /// ends.
    double turnCosine = 1.0;
};

/// More contacts of a disc than this are thinned out: the deepest of every patch stay.
inline constexpr std::size_t kMostPerSlice = 4;

/// Finds the points of a section that are nearest to the disc's centre: feet on its segments and
/// corners between them. Keeps its work space, so that nothing is allocated once it has grown.
class SliceContactFinder {
  public:
    SliceContactFinder();

    /// Contacts deeper than -margin, in order along the plane's u. Drops segments too short to
    /// matter.
    const std::vector<SliceContact>& find(std::vector<terrain::SliceSegment>& segments,
                                          const terrain::SlicePlane& plane, double radius,
                                          double margin);

    /// Of the last find(): the nearest face that the centre lies under, less than a radius deep.
    const std::optional<SliceContact>& behind() const { return behind_; }

  private:
    void addFace(const terrain::SliceSegment& segment);
    void addCorner(std::size_t index, bool atStart);
    void add(const SliceContact& contact);
    void thinOut();

    const std::vector<terrain::SliceSegment>* segments_ = nullptr;
    const terrain::SlicePlane* plane_ = nullptr;
    double radius_ = 0.0;
    double margin_ = 0.0;
    std::vector<SliceContact> contacts_;
    std::vector<SliceContact> kept_;
    std::optional<SliceContact> behind_;
    double behindHeight_ = 0.0;
};

}  // namespace simcore::contact
