#pragma once

#include <osg/Program>
#include <osg/StateSet>
#include <osg/Vec3>
#include <osg/ref_ptr>

/// The pictures' own shaders, GLSL 1.20: what an OpenGL 2.1 compatibility context can run.
namespace render {

/// Names of the uniforms that the scene sets.
namespace uniform {
inline constexpr const char* kSunDirection = "sunDirection";    ///< unit, towards the sun, world
inline constexpr const char* kFogColor = "fogColor";            ///< linear
inline constexpr const char* kZenithColor = "zenithColor";      ///< linear
inline constexpr const char* kFogCenter = "fogCenter";          ///< clear around here, world [m]
inline constexpr const char* kShadowMatrix = "shadowMatrix";    ///< world -> shadow map
inline constexpr const char* kShadowMap = "shadowMap";          ///< texture unit
inline constexpr const char* kShadowTexel = "shadowTexel";      ///< 1 / size of the shadow map
inline constexpr const char* kNoise = "noiseMap";               ///< texture unit
inline constexpr const char* kHighlight = "highlight";          ///< 0 or 1
inline constexpr const char* kGroundContact = "wheelContacts";  ///< xyz + radius of every wheel
}  // namespace uniform

inline constexpr int kShadowUnit = 2;
inline constexpr int kNoiseUnit = 1;

/// Towards the sun, world.
osg::Vec3 sunDirection();

/// Lit surfaces. Defines: SHADOWS, PCF (4 lookups); TERRAIN (soil instead of vertex finish), GRID.
osg::ref_ptr<osg::Program> makeSurfaceProgram();
/// Vertex colours as they are, with alpha.
osg::ref_ptr<osg::Program> makeFlatProgram();
/// Writes depth only.
osg::ref_ptr<osg::Program> makeDepthProgram();
/// The sky, on a quad that covers the screen.
osg::ref_ptr<osg::Program> makeSkyProgram();
/// Round labels on point sprites; the colour's red channel picks the glyph.
osg::ref_ptr<osg::Program> makeBadgeProgram();

/// Draws blended, after the solid things, without touching the target's alpha: a window system
/// would show it as a hole.
void makeBlended(osg::StateSet& state, int renderBin, bool depthTest);

}  // namespace render
