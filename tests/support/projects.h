#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "simcore/io/project_file.h"
#include "simcore/project/project.h"

/// The shipped projects, and a small one to spoil.
namespace testsupport {

inline std::filesystem::path shippedFile(const std::string& name) {
    return std::filesystem::path(ROVER_SOURCE_DIR) / "assets/projects" / (name + ".rover");
}

/// Every project file in assets/projects, by name.
inline std::vector<std::string> shippedNames() {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(shippedFile("solero").parent_path())) {
        if (entry.path().extension() == ".rover") {
            names.push_back(entry.path().stem().string());
        }
    }
    return names;
}

inline simcore::project::Project shipped(const std::string& name) {
    auto project = simcore::io::loadProject(shippedFile(name));
    if (!project) {
        throw std::runtime_error(toString(project.problems()));
    }
    return std::move(project).value();
}

/// Takes the relaxed model away that a project has.
inline void clearRelaxed(simcore::project::Project& project) {
    for (auto& joint : project.rover.joints) {
        joint.relaxed.clear();
        joint.relaxedSides = simcore::project::Sides::Both;
    }
    for (auto& wheel : project.rover.wheels) {
        wheel.relaxedLateral = false;
        wheel.relaxedSides = simcore::project::Sides::Both;
    }
}

/// A cart: chassis on two mirrored wheels, three parameters, one variant and one scenario.
inline const char* cartText() {
    return R"({
  "format": "roverstudio-project",
  "version": 1,
  "rover": {
    "name": "Cart",
    "parameters": [
      {"name": "wheel_radius", "value": 0.1, "unit": "mm", "minimum": 0.05, "maximum": 0.5},
      {"name": "wheel_width", "value": "5 cm", "unit": "mm"},
      {"name": "track", "value": "wheel_radius*4", "unit": "mm"}
    ],
    "bodies": [
      {"name": "chassis", "mass": 5, "com": [0, 0, "wheel_radius"],
       "inertia": [0.1, 0.1, 0.1, 0.001, 0, 0]},
      {"name": "wheel", "mirror": true, "mass": 1, "com": [0, "track/2", "wheel_radius"]}
    ],
    "joints": [
      {"name": "axle", "mirror": true, "first": "chassis", "second": "wheel",
       "point": [0, "track/2", "wheel_radius"]}
    ],
    "wheels": [
      {"name": "wheel", "mirror": true, "body": "wheel", "axle": "axle",
       "radius": "wheel_radius", "width": "wheel_width"}
    ]
  },
  "variants": [
    {"name": "big", "set": [{"parameter": "wheel_radius", "value": "15 cm"}]}
  ],
  "scenarios": [
    {"name": "step", "variant": "big",
     "terrain": {"kind": "step", "height": "2*wheel_radius", "length": 0.5}}
  ]
})";
}

inline simcore::project::Project cart() {
    auto project = simcore::io::parseProject(cartText(), "cart");
    if (!project) {
        throw std::runtime_error(toString(project.problems()));
    }
    return std::move(project).value();
}

}  // namespace testsupport
