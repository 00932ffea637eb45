#include "render/geometry/terrain_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <osg/Geode>

#include "render/geometry/mesh_builder.h"
#include "simcore/terrain/mesh_edges.h"

namespace render {

namespace {

using simcore::terrain::TriangleMesh;

constexpr double kSmoothCosine = 0.866;  // 30 deg
constexpr double kHorizon = 60.0;        // [m]; the fog is opaque before
const Material kSoil{osg::Vec4ub(160, 118, 83, 255), 1.0F, 0.0F};

// Ground with more triangles than this is drawn smooth all over and not welded: creases take too
// long to find, and its triangles are small.
constexpr std::size_t kMostCreased = 400'000;

/// Numbers of the vertices, the same for those at the same place.
std::vector<int> weld(const std::vector<Vec3>& vertices) {
    if (vertices.size() > kMostCreased) {
        std::vector<int> same(vertices.size());
        std::iota(same.begin(), same.end(), 0);
        return same;
    }
    return simcore::terrain::weldVertices(vertices);
}

/// Vertices, normals and corners of the ground.
struct Surface {
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array;
    osg::ref_ptr<osg::DrawElementsUInt> corners = new osg::DrawElementsUInt(GL_TRIANGLES);
};

Surface smoothSurface(const TriangleMesh& mesh) {
    Surface surface;
    std::vector<Vec3> sums(mesh.vertices.size(), Vec3::Zero());
    surface.corners->reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        const auto at = [&](std::size_t k) {
            return mesh.vertices[static_cast<std::size_t>(triangle[k])];
        };
        const Vec3 weighted = (at(1) - at(0)).cross(at(2) - at(0));
        for (const int corner : triangle) {
            sums[static_cast<std::size_t>(corner)] += weighted;
            surface.corners->push_back(static_cast<unsigned>(corner));
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        surface.vertices->push_back(toOsg(mesh.vertices[i]));
        surface.normals->push_back(toOsg(sums[i].normalized()));
    }
    return surface;
}

Surface creasedSurface(const TriangleMesh& mesh) {
    const std::vector<int> welded = weld(mesh.vertices);
    std::vector<Vec3> weighted(mesh.triangles.size());  // normal times twice the area
    std::vector<std::vector<int>> around(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)]; };
        weighted[t] = (at(b) - at(a)).cross(at(c) - at(a));
        for (const int corner : mesh.triangles[t]) {
            const auto spot = static_cast<std::size_t>(welded[static_cast<std::size_t>(corner)]);
            around[spot].push_back(static_cast<int>(t));
        }
    }
    Surface surface;
    osg::Vec3Array* vertices = surface.vertices;
    osg::Vec3Array* normals = surface.normals;
    osg::DrawElementsUInt* corners = surface.corners;
    std::vector<std::vector<unsigned>> drawn(mesh.vertices.size());  // once for each normal
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 own = weighted[t].normalized();
        for (const int corner : mesh.triangles[t]) {
            const auto index = static_cast<std::size_t>(corner);
            Vec3 sum = Vec3::Zero();
            for (const int other : around[static_cast<std::size_t>(welded[index])]) {
                const Vec3& neighbour = weighted[static_cast<std::size_t>(other)];
                if (neighbour.normalized().dot(own) > kSmoothCosine) {
                    sum += neighbour;
                }
            }
            const osg::Vec3 normal = toOsg(sum.normalized());
            const auto same = std::find_if(drawn[index].begin(), drawn[index].end(),
                                           [&](unsigned i) { return (*normals)[i] == normal; });
            if (same != drawn[index].end()) {
                corners->push_back(*same);
                continue;
            }
            drawn[index].push_back(static_cast<unsigned>(vertices->size()));
            corners->push_back(drawn[index].back());
            vertices->push_back(toOsg(mesh.vertices[index]));
            normals->push_back(normal);
        }
    }
    return surface;
}

osg::ref_ptr<osg::Geometry> makeSurface(const TriangleMesh& mesh) {
    const Surface surface =
        mesh.triangles.size() > kMostCreased ? smoothSurface(mesh) : creasedSurface(mesh);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(surface.vertices);
    geometry->setNormalArray(surface.normals, osg::Array::BIND_PER_VERTEX);
    osg::ref_ptr<osg::Vec4ubArray> color = new osg::Vec4ubArray;
    color->push_back(kSoil.color);
    color->setNormalize(true);
    geometry->setColorArray(color, osg::Array::BIND_OVERALL);
    geometry->addPrimitiveSet(surface.corners);
    return geometry;
}

/// Walls from the mesh's border to z = 0, where the surrounding lies.
void addBorder(MeshBuilder& builder, const TriangleMesh& mesh) {
    const auto edges = simcore::terrain::sortedEdges(mesh, weld(mesh.vertices));
    simcore::terrain::forEachEdge(edges, [&](std::span<const simcore::terrain::MeshEdge> same) {
        if (same.size() > 1) {
            return;  // not on the border
        }
        const Vec3& a = mesh.vertices[static_cast<std::size_t>(same[0].ends[0])];
        const Vec3& b = mesh.vertices[static_cast<std::size_t>(same[0].ends[1])];
        const Vec3 outward = (b - a).cross(Vec3::UnitZ());
        if (outward.norm() < 1e-9 || std::max(std::abs(a.z()), std::abs(b.z())) < 1e-6) {
            return;
        }
        const double sign = a.z() + b.z() >= 0.0 ? 1.0 : -1.0;  // a pit's wall looks inwards
        builder.quad({a, b, Vec3(b.x(), b.y(), 0.0), Vec3(a.x(), a.y(), 0.0)},
                     Vec3(sign * outward.normalized()));
    });
}

/// The plane z = 0 around the box [xMin, xMax] x [yMin, yMax].
void addSurrounding(MeshBuilder& builder, const Eigen::AlignedBox2d& hole) {
    const double x[4] = {hole.min().x() - kHorizon, hole.min().x(), hole.max().x(),
                         hole.max().x() + kHorizon};
    const double y[4] = {hole.min().y() - kHorizon, hole.min().y(), hole.max().y(),
                         hole.max().y() + kHorizon};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if ((i == 1 && j == 1) && !hole.isEmpty() && hole.volume() > 0.0) {
                continue;
            }
            builder.quad({Vec3(x[i], y[j], 0), Vec3(x[i + 1], y[j], 0), Vec3(x[i + 1], y[j + 1], 0),
                          Vec3(x[i], y[j + 1], 0)},
                         Vec3::UnitZ());
        }
    }
}

}  // namespace

Ground makeGround(const simcore::terrain::Terrain* terrain) {
    Ground ground{new osg::Group, nullptr};
    MeshBuilder around;
    around.setMaterial(kSoil);
    Eigen::AlignedBox2d hole(Eigen::Vector2d::Zero());
    if (terrain != nullptr && !terrain->mesh().triangles.empty()) {
        osg::ref_ptr<osg::Geode> surface = new osg::Geode;
        surface->addDrawable(makeSurface(terrain->mesh()));
        ground.measured = surface;
        ground.root->addChild(surface);
        hole = Eigen::AlignedBox2d();
        for (const Vec3& p : terrain->mesh().vertices) {
            hole.extend(Eigen::Vector2d(p.head<2>()));
        }
        addBorder(around, terrain->mesh());
    }
    addSurrounding(around, hole);
    osg::ref_ptr<osg::Geode> plain = new osg::Geode;
    plain->addDrawable(around.build());
    ground.root->addChild(plain);
    if (ground.measured == nullptr) {
        ground.measured = plain;
    }
    return ground;
}

}  // namespace render
