// Pictures drawn with EGL, without a window: what is to be seen, and that looking changes nothing.
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <osgDB/ReadFile>

#include <gtest/gtest.h>

#include "render/look/shaders.h"
#include "render/offscreen.h"
#include "tests/support/rovers.h"
#include "tests/support/snapshots.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace testsupport;
using render::CameraPose;
using render::Image;
using render::OffscreenRenderer;
using render::Overlays;
using render::Scene;
using render::View;

namespace {

constexpr int kWidth = 320, kHeight = 240;

struct Pixel {
    int x = 0, y = 0;
};

std::array<int, 3> colorAt(const Image& image, Pixel p) {
    const std::size_t at =
        4 * (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(image.width) +
             static_cast<std::size_t>(p.x));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

double brightness(const Image& image, Pixel p) {
    const auto [r, g, b] = colorAt(image, p);
    return (r + g + b) / 3.0;
}

std::vector<Pixel> allPixels(const Image& image) {
    std::vector<Pixel> pixels;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            pixels.push_back({x, y});
        }
    }
    return pixels;
}

/// Pixels whose colour differs by more than `tolerance` in some channel.
std::vector<Pixel> changed(const Image& a, const Image& b, int tolerance = 6) {
    std::vector<Pixel> pixels;
    for (const Pixel p : allPixels(a)) {
        const auto first = colorAt(a, p), second = colorAt(b, p);
        for (std::size_t c = 0; c < 3; ++c) {
            if (std::abs(first[c] - second[c]) > tolerance) {
                pixels.push_back(p);
                break;
            }
        }
    }
    return pixels;
}

/// Mean colour of the rows from `from` to `to`, as shares of the height.
Vec3 meanColor(const Image& image, double from, double to) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const Pixel p : allPixels(image)) {
        const double at = (p.y + 0.5) / image.height;
        if (at >= from && at < to) {
            const auto [r, g, b] = colorAt(image, p);
            sum += Vec3(r, g, b);
            ++count;
        }
    }
    return sum / count;
}

/// The camera's geometry: between world and pixels.
class Lens {
  public:
    Lens(const CameraPose& camera, int width, int height)
        : eye_(camera.eye),
          ahead_((camera.center - camera.eye).normalized()),
          right_(ahead_.cross(camera.up).normalized()),
          up_(right_.cross(ahead_)),
          width_(width),
          height_(height),
          focal_(0.5 * height / std::tan(0.5 * render::kFieldOfView * std::numbers::pi / 180.0)) {}

    Eigen::Vector2d toPixel(const Vec3& p) const {
        const double scale = focal_ / (p - eye_).dot(ahead_);
        return {0.5 * width_ + scale * (p - eye_).dot(right_),
                0.5 * height_ - scale * (p - eye_).dot(up_)};
    }

    double pixelsPerMetre(const Vec3& p) const { return focal_ / (p - eye_).dot(ahead_); }

    Vec3 eye() const { return eye_; }

    Vec3 direction(Pixel p) const {
        return (focal_ * ahead_ + (p.x + 0.5 - 0.5 * width_) * right_ -
                (p.y + 0.5 - 0.5 * height_) * up_)
            .normalized();
    }

  private:
    Vec3 eye_, ahead_, right_, up_;
    double width_, height_, focal_;
};

class PictureTest : public testing::Test {
  protected:
    PictureTest() : renderer(make(kWidth, kHeight)) {
        scene = std::make_unique<Scene>();
        scene->setMechanism(mechanism);
    }

    static std::unique_ptr<OffscreenRenderer> make(int width, int height, int samples = 0) {
        auto made = OffscreenRenderer::create(width, height, samples);
        if (!made) {
            throw std::runtime_error(toString(made.problems()));
        }
        return std::move(made).value();
    }

    Image draw(const CameraPose& camera) { return renderer->draw(*scene, camera); }

    Image draw(View view) { return draw(scene->view(view, renderer->aspect())); }

    Lens lens(View view) { return {scene->view(view, renderer->aspect()), kWidth, kHeight}; }

    const mechanism::Mechanism mechanism = mechanismOf("solero");
    std::unique_ptr<OffscreenRenderer> renderer;
    std::unique_ptr<Scene> scene;  ///< goes before the renderer
};

/// Everything that can be shown over the rover.
Overlays everything() {
    return {.centerOfMass = true,
            .supportPolygon = true,
            .contactForces = true,
            .jointFreedoms = true,
            .trail = true,
            .axes = true};
}

/// Where the pixel's ray meets z = 0, when it does.
std::optional<Vec3> onGround(const Lens& lens, Pixel p) {
    const Vec3 way = lens.direction(p);
    if (way.z() > -1e-6) {
        return std::nullopt;
    }
    return Vec3(lens.eye() - lens.eye().z() / way.z() * way);
}

}  // namespace

// Looking level ahead, the upper half is a bluish sky and the lower half sandy ground.
TEST_F(PictureTest, SkyIsAboveAndGroundBelow) {
    CameraPose camera;
    camera.eye = Vec3(-1.0, -6.0, 1.5);
    camera.center = camera.eye - Vec3::UnitY();
    const Image image = draw(camera);
    const Vec3 sky = meanColor(image, 0.0, 0.3), ground = meanColor(image, 0.7, 1.0);
    EXPECT_GT(sky.z(), sky.x());
    EXPECT_GT(ground.x(), ground.z() + 20.0);
    EXPECT_GT(ground.minCoeff(), 20.0);
}

// The picture has the size asked for, is opaque everywhere and shows many colours.
TEST_F(PictureTest, PictureIsFullAndOpaque) {
    scene->setJointFreedomCounts(std::vector<int>(mechanism.joints.size(), 2));
    scene->setOverlays(everything());
    scene->setSnapshot(standing(mechanism));
    const Image image = draw(View::Iso);
    ASSERT_EQ(image.width, kWidth);
    ASSERT_EQ(image.height, kHeight);
    ASSERT_EQ(image.rgba.size(), 4U * kWidth * kHeight);
    std::set<std::array<int, 3>> colors;
    for (const Pixel p : allPixels(image)) {
        colors.insert(colorAt(image, p));
    }
    EXPECT_GT(colors.size(), 1000U);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        ASSERT_EQ(image.rgba[i], 255);
    }
}

// Each near wheel covers its disc in the picture: lighting it up changes just those pixels.
TEST_F(PictureTest, WheelsAreWhereTheirBodiesAre) {
    scene->setOverlays({.shadow = false});
    Pose pose;
    pose.position = Vec3(0.4, 0.2, 0.05);
    scene->setSnapshot(standing(mechanism, pose, 0.2));
    const Lens side = lens(View::Side);
    const Image plain = draw(View::Side);
    for (const char* name : {"bogie_right_front", "bogie_right_rear"}) {
        const auto& wheel = mechanism.wheels[static_cast<std::size_t>(mechanism.findWheel(name))];
        scene->highlight({{}, {wheel.body}});
        const auto pixels = changed(plain, draw(View::Side), 3);
        scene->highlight({});
        const Vec3 face = pose * (wheel.center - 0.5 * wheel.width * Vec3::UnitY());
        const double radius = wheel.radius * side.pixelsPerMetre(face);
        for (const Pixel p : pixels) {
            const Eigen::Vector2d at(p.x + 0.5, p.y + 0.5);
            EXPECT_LT((at - side.toPixel(face)).norm(), 1.1 * radius + 1.5) << name;
        }
        EXPECT_GT(static_cast<double>(pixels.size()), 0.5 * std::numbers::pi * radius * radius);
    }
}

// A turning wheel is seen to turn, and nothing else moves.
TEST_F(PictureTest, TurningWheelsChangeTheirPixelsOnly) {
    scene->setOverlays({.shadow = false});
    scene->setSnapshot(standing(mechanism));
    const Image before = draw(View::Side);
    scene->setSnapshot(standing(mechanism, {}, 0.13));
    const auto pixels = changed(before, draw(View::Side));
    const Lens side = lens(View::Side);
    std::vector<int> perWheel(mechanism.wheels.size(), 0);
    for (const Pixel p : pixels) {
        bool onWheel = false;
        for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
            const auto& wheel = mechanism.wheels[i];
            const Eigen::Vector2d away =
                Eigen::Vector2d(p.x + 0.5, p.y + 0.5) - side.toPixel(wheel.center);
            if (away.norm() < 1.1 * wheel.radius * side.pixelsPerMetre(wheel.center) + 2.0) {
                onWheel = true;
                ++perWheel[i];
            }
        }
        EXPECT_TRUE(onWheel) << p.x << ", " << p.y;
    }
    for (const char* name : {"front", "rear", "bogie_right_front", "bogie_right_rear"}) {
        EXPECT_GT(perWheel[static_cast<std::size_t>(mechanism.findWheel(name))], 15) << name;
    }
}

// The shadow lies where the rover is between the ground and the sun, and nowhere else.
TEST_F(PictureTest, ShadowDarkensTheGroundBehindTheRover) {
    const Image shaded = draw(View::Iso);
    scene->setOverlays({.shadow = false});
    const Image lit = draw(View::Iso);
    const Lens iso = lens(View::Iso);
    const osg::Vec3 direction = render::sunDirection();
    const Vec3 sun(direction.x(), direction.y(), direction.z());
    int dark = 0, darkBehind = 0, light = 0, lightFree = 0;
    for (const Pixel p : allPixels(lit)) {
        if ((p.x + p.y) % 3 != 0) {
            continue;
        }
        const render::Pick seen = scene->pick(iso.eye(), iso.eye() + 50.0 * iso.direction(p), 0.0);
        if (seen.body >= 0 || !seen.point) {
            continue;
        }
        const double ratio = brightness(shaded, p) / std::max(brightness(lit, p), 1.0);
        ASSERT_LT(ratio, 1.05);
        const Vec3 from = *seen.point + 1e-3 * sun;
        const bool behind = scene->pick(from, from + 4.0 * sun, 0.0).body >= 0;
        if (ratio < 0.9) {
            ++dark;
            darkBehind += behind ? 1 : 0;
        } else {
            ++light;
            lightFree += behind ? 0 : 1;
        }
    }
    EXPECT_GT(dark, 300);
    EXPECT_GT(darkBehind, 0.9 * dark);
    EXPECT_GT(light, 5000);
    EXPECT_GT(lightFree, 0.99 * light);
}

// The finer shadow of a real graphics card covers the same ground.
TEST_F(PictureTest, FineShadowCoversTheSameGround) {
    const auto shadowArea = [this] {
        scene->setOverlays({.shadow = false});
        const Image lit = draw(View::Iso);
        scene->setOverlays({});
        return static_cast<double>(changed(lit, draw(View::Iso), 12).size());
    };
    const double coarse = shadowArea();
    scene->setQuality({.shadowSize = 2048, .shadowTaps = 4});
    EXPECT_NEAR(shadowArea(), coarse, 0.15 * coarse);
}

// One instant is one picture, also after looking at another one: nothing is left behind.
TEST_F(PictureTest, PictureIsAFunctionOfTheInstant) {
    scene->setOverlays(everything());
    const auto first = rolled(mechanism, 0.0, 0.0), later = rolled(mechanism, 0.3, 3.0);
    CameraPose camera = scene->view(View::Iso, renderer->aspect());
    scene->setSnapshot(first);
    const Image before = draw(camera);
    scene->setSnapshot(later);
    EXPECT_GT(changed(before, draw(camera)).size(), 1000U);
    scene->setSnapshot(first);
    EXPECT_EQ(draw(camera).rgba, before.rgba);
}

// Drawing, from anywhere and as often as one likes, changes neither trail nor poses nor picture.
TEST_F(PictureTest, DrawingChangesNothing) {
    scene->setOverlays(everything());
    for (int i = 0; i < 5; ++i) {
        scene->setSnapshot(rolled(mechanism, 0.1 * i, 0.1 * i));
    }
    const Image before = draw(View::Iso);
    draw(View::Top);
    draw(View::Front);
    EXPECT_EQ(draw(View::Iso).rgba, before.rgba);
    EXPECT_EQ(scene->trailLength(), 5);
    EXPECT_NEAR(scene->bodyPose(0).position.x(), 0.4, 1e-12);
}

// A dark window gets a dark sky, a light one a light sky; the ground's light is the same.
TEST_F(PictureTest, SkyGoesWithTheTheme) {
    CameraPose camera;
    camera.eye = Vec3(-1.0, -6.0, 1.5);
    camera.center = camera.eye - Vec3::UnitY();
    scene->setTheme(false);
    const Vec3 light = meanColor(draw(camera), 0.0, 0.4);
    scene->setTheme(true);
    const Vec3 dark = meanColor(draw(camera), 0.0, 0.4);
    EXPECT_GT(light.mean(), 110.0);
    EXPECT_LT(dark.mean(), 80.0);
}

// Every overlay is to be seen when it is on, and leaves no trace when it is off again.
TEST_F(PictureTest, EveryOverlayShowsAndGoes) {
    const std::vector<std::pair<bool Overlays::*, const char*>> switches = {
        {&Overlays::centerOfMass, "centre of mass"},
        {&Overlays::supportPolygon, "support polygon"},
        {&Overlays::contactForces, "contact forces"},
        {&Overlays::jointFreedoms, "joint freedoms"},
        {&Overlays::trail, "trail"},
        {&Overlays::grid, "grid"},
        {&Overlays::axes, "axes"},
        {&Overlays::shadow, "shadow"}};
    scene->setJointFreedomCounts(std::vector<int>(mechanism.joints.size(), 3));
    for (int i = 0; i < 4; ++i) {
        scene->setSnapshot(rolled(mechanism, 0.1 * i, 0.1 * i));
    }
    Overlays none;
    none.grid = none.shadow = false;
    scene->setOverlays(none);
    const Image bare = draw(View::Iso);
    for (const auto& [overlay, name] : switches) {
        Overlays one = none;
        one.*overlay = true;
        scene->setOverlays(one);
        EXPECT_GT(changed(bare, draw(View::Iso), 10).size(), 60U) << name;
        scene->setOverlays(none);
        EXPECT_EQ(draw(View::Iso).rgba, bare.rgba) << name;
    }
}

// A digit at a joint is a disc at the joint's place in the picture; other digits look different.
TEST_F(PictureTest, FreedomsAreReadableAtTheirJoints) {
    const int joint = mechanism.findJoint("fork_a");
    ASSERT_GE(joint, 0);
    const Image bare = draw(View::Side);
    scene->setOverlays({.jointFreedoms = true});
    scene->setJointFreedomCounts(std::vector<int>(mechanism.joints.size(), 1));
    const Image ones = draw(View::Side);
    scene->setJointFreedomCounts(std::vector<int>(mechanism.joints.size(), 4));
    const Image fours = draw(View::Side);
    const Eigen::Vector2d at =
        lens(View::Side).toPixel(mechanism.joints[static_cast<std::size_t>(joint)].point);
    const auto near = [&](const std::vector<Pixel>& pixels) {
        return std::count_if(pixels.begin(), pixels.end(), [&](Pixel p) {
            return (Eigen::Vector2d(p.x + 0.5, p.y + 0.5) - at).norm() < 11.0;
        });
    };
    EXPECT_GT(near(changed(bare, ones)), 250);  // a disc of 22 pixels, its corners left out
    EXPECT_GT(near(changed(ones, fours, 40)), 20);
    EXPECT_LT(near(changed(ones, fours, 40)), 200);
}

// The grid is metric: seen from above, its strong lines lie at whole metres.
TEST_F(PictureTest, GridLinesLieAtWholeMetres) {
    CameraPose camera;
    camera.center = Vec3(3.3, 0.2, 0.0);
    camera.eye = camera.center + Vec3(0.0, 0.0, 6.0);
    camera.up = Vec3::UnitX();
    const Lens above(camera, kWidth, kHeight);
    scene->setOverlays({});
    const Image grid = draw(camera);
    scene->setOverlays({.grid = false});
    const Image bare = draw(camera);
    const double pixel = 1.0 / above.pixelsPerMetre(camera.center);
    int onLine = 0, onLineDark = 0, strong = 0;
    for (const Pixel p : allPixels(bare)) {
        const auto ground = onGround(above, p);
        ASSERT_TRUE(ground.has_value());
        const double off = std::min(std::abs(ground->x() - std::round(ground->x())),
                                    std::abs(ground->y() - std::round(ground->y())));
        const double ratio = brightness(grid, p) / std::max(brightness(bare, p), 1.0);
        if (ratio < 0.88) {
            ++strong;
            EXPECT_LT(off, 1.6 * pixel);
        }
        if (off < 0.4 * pixel) {
            ++onLine;
            onLineDark += ratio < 0.88 ? 1 : 0;
        }
    }
    EXPECT_GT(onLine, 500);
    EXPECT_GT(onLineDark, 0.95 * onLine);
    EXPECT_GT(strong, 500);
}

// The terrain is drawn where it is: a rover behind a wall is hidden, from the other side it is not.
TEST_F(PictureTest, WallHidesWhatIsBehindIt) {
    scene->setTerrain(std::make_shared<const terrain::Terrain>(terrain::Terrain::extruded(
        {{-5, 0}, {1.0, 0}, {1.0, 1.5}, {1.3, 1.5}, {1.3, 0}, {6, 0}}, -4.0, 4.0)));
    scene->setOverlays({.shadow = false});
    for (const double side : {1.0, -1.0}) {
        CameraPose camera;
        camera.eye = Vec3(side * 4.5, 0.3, 0.5);
        camera.center = Vec3(0.0, 0.0, 0.3);
        const Image plain = draw(camera);
        scene->highlight({{}, {mechanism.chassis}});
        const auto pixels = changed(plain, draw(camera), 3);
        scene->highlight({});
        EXPECT_EQ(pixels.empty(), side > 0.0) << "seen from x = " << camera.eye.x();
    }
}

// A large picture shows the same as a small one, only finer.
TEST_F(PictureTest, LargePictureShowsTheSame) {
    scene->setSnapshot(standing(mechanism));
    const CameraPose camera = scene->view(View::Overview, renderer->aspect());
    const Image small = draw(camera);
    constexpr int kTimes = 5;
    const auto large = make(kTimes * kWidth, kTimes * kHeight);
    Scene other;
    other.setMechanism(mechanism);
    other.setSnapshot(standing(mechanism));
    const Image big = large->draw(other, camera);
    ASSERT_EQ(big.width, kTimes * kWidth);
    double difference = 0.0;
    for (const Pixel p : allPixels(small)) {
        double sum = 0.0;
        for (int i = 0; i < kTimes * kTimes; ++i) {
            sum += brightness(big, {p.x * kTimes + i % kTimes, p.y * kTimes + i / kTimes});
        }
        difference += std::abs(sum / (kTimes * kTimes) - brightness(small, p));
    }
    EXPECT_LT(difference / (kWidth * kHeight), 6.0);
}

// Multisampling smooths edges: few pixels change, and those lie between their neighbours' colours.
TEST_F(PictureTest, MultisamplingSmoothsEdges) {
    const auto smooth = make(kWidth, kHeight, 4);
    Scene other;
    other.setMechanism(mechanism);
    const CameraPose camera = scene->view(View::Iso, renderer->aspect());
    const auto pixels = changed(draw(camera), smooth->draw(other, camera), 20);
    EXPECT_GT(pixels.size(), 100U);
    EXPECT_LT(pixels.size(), 0.1 * kWidth * kHeight);
}

// One renderer may draw several scenes in turn; none of them shows in another.
TEST_F(PictureTest, OneRendererDrawsSeveralScenes) {
    const CameraPose camera = scene->view(View::Iso, renderer->aspect());
    const Image solero = draw(camera);
    {
        Scene other;
        other.setMechanism(mechanismOf("rocker_bogie"));
        EXPECT_GT(changed(solero, renderer->draw(other, camera)).size(), 1000U);
    }
    EXPECT_EQ(draw(camera).rgba, solero.rgba);
}

// A new rover, a new terrain and a new shadow map in the midst of drawing look as if made at once.
TEST_F(PictureTest, ScenesCanBeChangedBetweenPictures) {
    const auto ground =
        std::make_shared<const terrain::Terrain>(made(spec(project::TerrainKind::Step, 0.1, 1.2)));
    const auto bogie = mechanismOf("rocker_bogie");
    draw(View::Iso);
    scene->setQuality({.shadowSize = 512});
    scene->setTerrain(ground);
    draw(View::Iso);
    scene->setMechanism(bogie);
    const Image changedScene = draw(View::Overview);
    Scene fresh;
    fresh.setQuality({.shadowSize = 512});
    fresh.setMechanism(bogie);
    fresh.setTerrain(ground);
    const Image made = renderer->draw(fresh, fresh.view(View::Overview, renderer->aspect()));
    EXPECT_EQ(made.rgba, changedScene.rgba);
}

// A second rover is seen through, hides nothing behind it, and leaves no trace when it goes.
TEST_F(PictureTest, AGhostIsPaleAndGoesWithoutATrace) {
    const Image alone = draw(View::Side);
    auto ghost = std::make_shared<const mechanism::Mechanism>(mechanism);
    std::vector<Pose> poses(mechanism.bodies.size());
    for (Pose& pose : poses) {
        pose.position = Vec3(0.25, 0.0, 0.15);
    }
    scene->setGhost(ghost, poses);
    EXPECT_TRUE(scene->hasGhost());
    const Image both = draw(View::Side);
    const std::vector<Pixel> paler = changed(alone, both, 0);
    EXPECT_GT(paler.size(), allPixels(alone).size() / 100);
    for (const Pixel p : paler) {
        // A mixture: nowhere the ghost's own blue alone.
        EXPECT_LT(colorAt(both, p)[2], 250);
        EXPECT_GT(colorAt(both, p)[2], 30);
    }
    // Where it stands before the sandy ground, that shines through bluer than it was.
    const auto bluer = std::count_if(paler.begin(), paler.end(), [&](Pixel p) {
        return colorAt(both, p)[2] - colorAt(both, p)[0] >
               colorAt(alone, p)[2] - colorAt(alone, p)[0];
    });
    EXPECT_GT(bluer, static_cast<std::ptrdiff_t>(paler.size()) * 9 / 10);
    scene->setGhost(nullptr, {});
    EXPECT_EQ(draw(View::Side).rgba, alone.rgba);
    EXPECT_THROW(scene->setGhost(ghost, {}), std::invalid_argument);
}

// A renderer without a size is a mistake of the programmer.
TEST_F(PictureTest, PictureWithoutSizeIsRefused) {
    EXPECT_THROW((void)OffscreenRenderer::create(0, 100), std::invalid_argument);
    EXPECT_THROW((void)OffscreenRenderer::create(100, -1), std::invalid_argument);
}

// The file holds the picture, upright and pixel for pixel.
TEST_F(PictureTest, PngHoldsThePicture) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("picture_test_" + std::to_string(getpid()) + ".png");
    const Image image = draw(View::Overview);
    EXPECT_TRUE(render::writePng(image, file).empty());
    const osg::ref_ptr<osg::Image> read = osgDB::readRefImageFile(file.string());
    std::filesystem::remove(file);
    ASSERT_NE(read, nullptr);
    ASSERT_EQ(read->s(), image.width);
    ASSERT_EQ(read->t(), image.height);
    for (const Pixel p : allPixels(image)) {
        const unsigned char* pixel =
            read->data(static_cast<unsigned>(p.x), static_cast<unsigned>(image.height - 1 - p.y));
        const auto [r, g, b] = colorAt(image, p);
        ASSERT_TRUE(pixel[0] == r && pixel[1] == g && pixel[2] == b) << p.x << ", " << p.y;
    }
}

// Where no file can be written the problem names it; so does an ending that is no picture's.
TEST_F(PictureTest, UnwritablePngIsAProblem) {
    const Image image = draw(View::Iso);
    for (const char* file : {"/nonexistent/folder/picture.png", "/nonexistent/picture.xyz"}) {
        const Problems problems = render::writePng(image, file);
        ASSERT_EQ(problems.size(), 1U);
        EXPECT_EQ(problems.front().element, file);
        EXPECT_FALSE(problems.front().remedy.empty());
    }
}
