#include "render/look/shaders.h"

#include <osg/BlendFunc>
#include <osg/ColorMask>
#include <osg/Depth>
#include <string>

namespace render {

namespace {

// Colours are stored as sRGB; squaring stands in for the exact curve, sqrt undoes it.
constexpr const char* kCommon = R"(
uniform vec3 sunDirection;
uniform vec3 fogColor;
uniform vec3 zenithColor;
uniform vec3 fogCenter;

vec3 skyColor(vec3 d) {
    float up = clamp(d.z, 0.0, 1.0);
    vec3 c = mix(fogColor, zenithColor, 1.0 - exp(-4.5 * up));
    float glow = max(dot(d, sunDirection), 0.0);
    glow = glow * glow; glow = glow * glow;
    return c + vec3(0.16, 0.11, 0.06) * glow * glow;
}
vec3 toScreen(vec3 c) {
    return sqrt(1.0 - exp(-1.55 * c));
}
)";

constexpr const char* kSurfaceVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
varying vec3 worldPosition;
varying vec3 worldNormal;
varying vec3 viewVector;
varying vec4 albedo;
varying vec2 finish;
void main() {
    vec4 inEye = gl_ModelViewMatrix * gl_Vertex;
    worldPosition = (osg_ViewMatrixInverse * inEye).xyz;
    worldNormal = mat3(osg_ViewMatrixInverse) * (gl_NormalMatrix * gl_Normal);
    viewVector = osg_ViewMatrixInverse[3].xyz - worldPosition;
    albedo = gl_Color;
    finish = gl_MultiTexCoord0.xy;
    gl_Position = gl_ProjectionMatrix * inEye;
}
)";

constexpr const char* kSurfaceFragment = R"(
uniform sampler2DShadow shadowMap;
uniform sampler2D noiseMap;
uniform mat4 shadowMatrix;
uniform float shadowTexel;
uniform float highlight;
uniform vec4 wheelContacts[8];
varying vec3 worldPosition;
varying vec3 worldNormal;
varying vec3 viewVector;
varying vec4 albedo;
varying vec2 finish;

float sunLight(vec3 n) {
#ifdef SHADOWS
    vec4 p = shadowMatrix * vec4(worldPosition + 0.0015 * n, 1.0);
    vec2 edge = abs(p.xy - 0.5);
    if (max(edge.x, edge.y) > 0.495) return 1.0;
    vec3 q = vec3(p.xy, min(p.z, 1.0) - 0.0004);
#ifdef PCF
    float t = 0.75 * shadowTexel;
    return 0.25 * (shadow2D(shadowMap, q + vec3(-t, -0.4 * t, 0.0)).r +
                   shadow2D(shadowMap, q + vec3(0.4 * t, -t, 0.0)).r +
                   shadow2D(shadowMap, q + vec3(t, 0.4 * t, 0.0)).r +
                   shadow2D(shadowMap, q + vec3(-0.4 * t, t, 0.0)).r);
#else
    return shadow2D(shadowMap, q).r;
#endif
#else
    return 1.0;
#endif
}

#ifdef GRID
// Coverage of lines at whole multiples of `pitch`, anti-aliased, about `width` pixels wide.
float lines(float x, float pitch, float width, float visible) {
    float s = x / pitch;
    float pixel = max(fwidth(s), 1.0e-5);
    float away = abs(fract(s - 0.5) - 0.5) / pixel;
    return (1.0 - smoothstep(0.5 * width - 0.5, 0.5 * width + 0.5, away)) *
           clamp(1.6 - 9.0 * pixel, 0.0, 1.0) * visible;
}
float gridCoverage(vec3 p, vec3 n) {
    vec3 flatness = vec3(1.0) - abs(n);
    float alongX = clamp(4.0 * flatness.x, 0.0, 1.0);
    float alongY = clamp(4.0 * flatness.y, 0.0, 1.0);
    float onWall = smoothstep(0.55, 0.85, flatness.z);
    float metre = max(lines(p.x, 1.0, 1.8, alongX), lines(p.y, 1.0, 1.8, alongY));
    float fine = max(lines(p.x, 0.1, 1.0, alongX), lines(p.y, 0.1, 1.0, alongY));
    fine = max(fine, lines(p.z, 0.1, 1.0, onWall));
    return max(0.62 * metre, 0.26 * fine);
}
#endif

void main() {
    vec3 n = normalize(worldNormal);
    vec3 v = normalize(viewVector);
    if (!gl_FrontFacing) n = -n;
    vec3 base = albedo.rgb * albedo.rgb;
    float ndl = dot(n, sunDirection);
    float light = ndl > 0.0 ? sunLight(n) : 0.0;
    ndl = max(ndl, 0.0);
    vec3 sun = vec3(2.05, 1.90, 1.66) * light * ndl;
    vec3 ambient = mix(vec3(0.30, 0.245, 0.20), vec3(0.50, 0.57, 0.68), 0.5 + 0.5 * n.z);
#ifdef TERRAIN
    float coarse = texture2D(noiseMap, worldPosition.xy * 0.21 + worldPosition.z * 0.13).r;
    float medium = texture2D(noiseMap, worldPosition.yx * 1.7 + worldPosition.z).r;
    float grain = texture2D(noiseMap, worldPosition.xy * 9.0 + worldPosition.zz * 7.0).r;
    base *= 0.74 + 0.22 * coarse + 0.18 * medium + 0.16 * grain;
    base = mix(base, base * vec3(0.80, 0.70, 0.63), smoothstep(0.25, 0.75, 1.0 - n.z));
    // Less sky reaches the ground close under a wheel.
    float open = 1.0;
    for (int i = 0; i < 8; ++i) {
        vec3 d = (worldPosition - wheelContacts[i].xyz) / max(wheelContacts[i].w, 1.0e-4);
        open -= 0.55 * clamp(1.0 - dot(d, d), 0.0, 1.0);
    }
    ambient *= max(open, 0.3);
    sun *= 0.55 + 0.45 * max(open, 0.0);
    vec3 color = base * (ambient + sun);
#ifdef GRID
    color = mix(color, color * 0.30, gridCoverage(worldPosition, n));
#endif
#else
    // GGX highlight, Schlick's Fresnel term; the sky stands in for the surroundings.
    float rough = max(finish.x, 0.08);
    vec3 f0 = mix(vec3(0.04), base, finish.y);
    vec3 h = normalize(v + sunDirection);
    float ndv = max(dot(n, v), 0.05);
    float ndh = max(dot(n, h), 0.0);
    float a2 = rough * rough * rough * rough;
    float spread = ndh * ndh * (a2 - 1.0) + 1.0;
    float k = 0.5 * rough * rough;
    float glint = a2 / (4.0 * spread * spread * (ndl * (1.0 - k) + k) * (ndv * (1.0 - k) + k));
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - max(dot(h, v), 0.0), 5.0);
    vec3 mirror = reflect(-v, n);
    vec3 around = mirror.z > 0.0 ? mix(skyColor(mirror), ambient, rough)
                                 : vec3(0.30, 0.23, 0.16);
    around = mix(vec3(0.30, 0.23, 0.16), around, smoothstep(-0.25, 0.25, mirror.z));
    vec3 rim = f0 + (max(vec3(1.0 - rough), f0) - f0) * pow(1.0 - ndv, 5.0);
    vec3 color = base * (1.0 - finish.y) * (ambient + sun) + rim * around +
                 fresnel * min(glint, 12.0) * sun * 0.32;
    // Lit from within: orange brighter and more colourful than sand or anodised parts.
    vec3 orange = vec3(1.0, 0.24, 0.01) * (0.6 + 0.5 * dot(color, vec3(0.3, 0.5, 0.2)));
    color = mix(color, orange, 0.85 * highlight);
    color += highlight * vec3(0.5, 0.2, 0.0) * (1.0 - ndv);
#endif
    float haze = length(worldPosition.xy - fogCenter.xy);
    float clear = exp2(-haze * haze * 0.0042);
    color = mix(fogColor, color, clear);
    vec3 screen = toScreen(color);
#ifdef GHOST
    // Pale blue, denser at its edges, so that it is told from the rover itself.
    float edge = 1.0 - max(dot(n, v), 0.0);
    gl_FragColor = vec4(mix(screen, vec3(0.48, 0.75, 1.0), 0.65), 0.42 + 0.45 * edge * edge);
#elif defined(BURIED)
    // Amber as what is highlighted, seen through what it is in.
    gl_FragColor = vec4(mix(screen, vec3(1.0, 0.58, 0.08), 0.7), 0.42);
#else
    gl_FragColor = vec4(screen, 1.0);
#endif
}
)";

constexpr const char* kFlatVertex = R"(
varying vec4 color;
void main() {
    color = gl_Color;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)";

constexpr const char* kFlatFragment = R"(
varying vec4 color;
void main() { gl_FragColor = color; }
)";

constexpr const char* kDepthVertex = R"(
void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }
)";

constexpr const char* kDepthFragment = R"(
void main() { gl_FragColor = vec4(1.0); }
)";

constexpr const char* kSkyVertex = R"(
uniform mat4 osg_ViewMatrixInverse;
varying vec3 ray;
void main() {
    vec4 inEye = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    ray = mat3(osg_ViewMatrixInverse) * (inEye.xyz / inEye.w);
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
}
)";

constexpr const char* kSkyFragment = R"(
varying vec3 ray;
void main() { gl_FragColor = vec4(toScreen(skyColor(normalize(ray))), 1.0); }
)";

constexpr const char* kBadgeVertex = R"(
varying float glyph;
void main() {
    glyph = floor(gl_Color.r * 255.0 + 0.5);
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)";

constexpr const char* kBadgeFragment = R"(
uniform sampler2D glyphs;
varying float glyph;
void main() {
    vec2 at = vec2((glyph + gl_PointCoord.x) / 8.0, gl_PointCoord.y);
    gl_FragColor = texture2D(glyphs, at);
}
)";

constexpr const char* kVersion = "#version 120\n";

osg::ref_ptr<osg::Program> makeProgram(const char* name, const std::string& vertex,
                                       const std::string& fragment) {
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(name);
    program->addShader(new osg::Shader(osg::Shader::VERTEX, kVersion + vertex));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, kVersion + fragment));
    return program;
}

}  // namespace

osg::Vec3 sunDirection() {
    osg::Vec3 direction(-0.34F, 0.46F, 0.82F);
    direction.normalize();
    return direction;
}

osg::ref_ptr<osg::Program> makeSurfaceProgram() {
    return makeProgram(
        "surface", kSurfaceVertex,
        std::string("#pragma import_defines(SHADOWS, PCF, TERRAIN, GRID, GHOST, BURIED)\n") +
            kCommon + kSurfaceFragment);
}

osg::ref_ptr<osg::Program> makeFlatProgram() {
    return makeProgram("flat", kFlatVertex, kFlatFragment);
}

osg::ref_ptr<osg::Program> makeDepthProgram() {
    return makeProgram("depth", kDepthVertex, kDepthFragment);
}

osg::ref_ptr<osg::Program> makeSkyProgram() {
    return makeProgram("sky", kSkyVertex, std::string(kCommon) + kSkyFragment);
}

osg::ref_ptr<osg::Program> makeBadgeProgram() {
    return makeProgram("badge", kBadgeVertex, kBadgeFragment);
}

void makeBlended(osg::StateSet& state, int renderBin, bool depthTest) {
    state.setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    state.setAttribute(new osg::ColorMask(true, true, true, false));
    state.setAttributeAndModes(
        new osg::Depth(depthTest ? osg::Depth::LEQUAL : osg::Depth::ALWAYS, 0.0, 1.0, false));
    state.setRenderBinDetails(renderBin, "DepthSortedBin");
}

}  // namespace render
