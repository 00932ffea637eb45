#include "simcore/io/mobility_json.h"

#include <cmath>

#include "simcore/base/version.h"

namespace simcore::io {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Vec3& v) {
    Json list = Json::array();
    for (int k = 0; k < 3; ++k) {
        // Directions are unit vectors: round-off beside zero is not worth a reader's time.
        list.push_back(std::abs(v[k]) < 1e-12 ? 0.0 : v[k]);
    }
    return list;
}

Json toJson(const std::vector<mobility::ConstraintName>& names) {
    Json list = Json::array();
    for (const mobility::ConstraintName& name : names) {
        list.push_back({{"element", name.element},
                        {"holds", name.kind},
                        {"direction", toJson(name.direction)},
                        {"share", name.share}});
    }
    return list;
}

}  // namespace

nlohmann::ordered_json toJson(const mobility::Report& report) {
    Json json;
    json["model"] = report.model == mobility::Model::Built ? "built" : "relaxed";
    json["bodies"] = report.bodies;
    Json joints;
    joints["total"] = report.joints;
    for (std::size_t i = 0; i < report.jointsByFreedom.size(); ++i) {
        joints["f" + std::to_string(i + 1)] = report.jointsByFreedom[i];
    }
    json["joints"] = joints;
    json["gruebler"] = report.gruebler;
    json["columns"] = report.columns;
    json["constraint_rows"] = report.rows;
    json["rank"] = report.rank;
    json["mobility"] = report.mobility;
    json["redundant"] = report.redundant;
    json["rank_gap"] = std::isfinite(report.rankGap) ? Json(report.rankGap) : Json(nullptr);
    json["verdict"] = mobility::describe(report);
    json["removable_constraints"] = toJson(report.removable);
    json["redundant_set"] = toJson(report.redundantSet);
    Json idle = Json::array();
    for (const mobility::IdleFreedom& freedom : report.idle) {
        idle.push_back({{"body", freedom.body},
                        {"turn", toJson(freedom.turn)},
                        {"slide", toJson(freedom.slide)}});
    }
    json["idle_freedoms"] = idle;
    return json;
}

nlohmann::ordered_json toJson(const Problems& problems) {
    Json list = Json::array();
    for (const Problem& problem : problems) {
        list.push_back({{"severity", toString(problem.severity)},
                        {"element", problem.element},
                        {"reason", problem.reason},
                        {"remedy", problem.remedy}});
    }
    return list;
}

nlohmann::ordered_json jsonDocument(const std::string& schema) {
    return {{"schema", schema}, {"program_version", programVersion()}};
}

}  // namespace simcore::io
