#pragma once

/// How the ground pushes what touches it, the same in every engine: a stiff spring with a damper
/// along the normal, solved implicitly, so that it is the same physics at every step, and a little
/// creep across it. Contacts are known before they touch and then only keep bodies from getting
/// through the ground within a step.
namespace simcore::dynamics {

inline constexpr double kContactStiffness = 1e6;  ///< [N/m] (assumed)
/// Critical for 6 kg, a rover's share on one wheel (assumed): with less, wheels bounce at edges
/// where the step is short enough to show it, and slip the more the shorter it is.
inline constexpr double kContactDamping = 5000;  // [N s/m]
/// What a wheel that sticks creeps: 0.1 um/s per newton (assumed). It decides how wheels that work
/// against each other share a load.
inline constexpr double kStickingDamping = 1e7;  // [N s/m]
/// Contacts are wanted from this far before they touch [m] (assumed).
inline constexpr double kContactMargin = 1e-3;

/// What a contact resists per rate after a step of it [N s/m]: v + F / r >= b,  with v the rate
/// along the normal after the step, F the force and r this.
constexpr double contactResistance(double step) {
    return kContactStiffness * step + kContactDamping;
}

/// b of the same [m/s].
/// @param depth  of the contact [m], negative before it touches
constexpr double contactRate(double depth, double step) {
    return depth > 0.0 ? depth * kContactStiffness / contactResistance(step) : depth / step;
}

}  // namespace simcore::dynamics
