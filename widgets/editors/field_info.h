#pragma once

#include <QString>

#include "simcore/project/project.h"

namespace widgets {

/// How an editor shows one field of an element.
struct FieldInfo {
    QString label;
    QString unit;     ///< display unit, "" = none
    QString tooltip;  ///< what it means
    bool shown = true;
};

/// `element` is the kind of element ("body", "motor", ...), `key` the field's name in the file.
FieldInfo fieldInfo(const QString& element, const QString& key);

/// A title's words in the middle of a sentence: small in English; German nouns keep their capital.
QString inSentence(const QString& title);

/// Fields of a terrain that its kind uses.
bool terrainUses(simcore::project::TerrainKind kind, const QString& key);

/// Fields of a shape that its kind uses.
bool shapeUses(simcore::project::ShapeKind kind, const QString& key);

inline const char* elementWord(const simcore::project::Parameter*) {
    return "parameter";
}

inline const char* elementWord(const simcore::project::Shape*) {
    return "shape";
}

inline const char* elementWord(const simcore::project::Body*) {
    return "body";
}

inline const char* elementWord(const simcore::project::Joint*) {
    return "joint";
}

inline const char* elementWord(const simcore::project::Motor*) {
    return "motor";
}

inline const char* elementWord(const simcore::project::SteeringMotor*) {
    return "steering_motor";
}

inline const char* elementWord(const simcore::project::Wheel*) {
    return "wheel";
}

inline const char* elementWord(const simcore::project::Spring*) {
    return "spring";
}

inline const char* elementWord(const simcore::project::Gear*) {
    return "gear";
}

inline const char* elementWord(const simcore::project::Payload*) {
    return "payload";
}

inline const char* elementWord(const simcore::project::Override*) {
    return "override";
}

inline const char* elementWord(const simcore::project::Variant*) {
    return "variant";
}

inline const char* elementWord(const simcore::project::Terrain*) {
    return "terrain";
}

inline const char* elementWord(const simcore::project::SoilRegion*) {
    return "region";
}

inline const char* elementWord(const simcore::project::Soil*) {
    return "soil";
}

inline const char* elementWord(const simcore::project::Controller*) {
    return "controller";
}

inline const char* elementWord(const simcore::project::SensorError*) {
    return "sensor";
}

inline const char* elementWord(const simcore::project::Sensors*) {
    return "sensors";
}

inline const char* elementWord(const simcore::project::RunSettings*) {
    return "run";
}

inline const char* elementWord(const simcore::project::Scenario*) {
    return "scenario";
}

}  // namespace widgets
