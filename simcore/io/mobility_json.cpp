#include "simcore/io/mobility_json.h"

#include <cmath>

#include "simcore/base/version.h"
#include "simcore/io/json_format.h"
#include "simcore/mobility/selection.h"
#include "simcore/project/names.h"

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

const char* toText(mobility::Continuation continuation) {
    switch (continuation) {
        case mobility::Continuation::Finite:
            return "finite";
        case mobility::Continuation::Branch:
            return "branch";
        case mobility::Continuation::Infinitesimal:
            return "infinitesimal";
    }
    return "";
}

const char* toText(mobility::Determinacy determinacy) {
    switch (determinacy) {
        case mobility::Determinacy::All:
            return "all";
        case mobility::Determinacy::Some:
            return "some";
        case mobility::Determinacy::None:
            return "none";
    }
    return "";
}

Json toJson(const mobility::MovedPose& moved) {
    Json json;
    json["rank"] = moved.rank;
    json["mobility"] = moved.mobility;
    json["redundant"] = moved.redundant;
    json["rank_gap"] = numberOrNull(moved.rankGap);
    json["free_motions"] = Json::array();
    for (const mobility::FreeMotion& motion : moved.motions) {
        Json inconsistent = Json::array();
        for (const mobility::Inconsistency& row : motion.inconsistent) {
            inconsistent.push_back({{"element", row.constraint.element},
                                    {"holds", row.constraint.kind},
                                    {"direction", toJson(row.constraint.direction)},
                                    {"gap", row.gap}});
        }
        json["free_motions"].push_back({{"body", motion.body},
                                        {"turn", toJson(motion.turn)},
                                        {"slide", toJson(motion.slide)},
                                        {"continuation", toText(motion.continuation)},
                                        {"closure", motion.closure},
                                        {"inconsistent", inconsistent}});
    }
    return json;
}

Json toJson(const std::vector<mobility::ReactionDeterminacy>& reactions) {
    Json list = Json::array();
    for (const mobility::ReactionDeterminacy& reaction : reactions) {
        Json components = Json::array();
        for (const mobility::ReactionComponent& component : reaction.determined) {
            components.push_back({{"force", toJson(component.force)},
                                  {"torque", toJson(component.torque)},
                                  {"lever", component.lever}});
        }
        list.push_back({{"element", reaction.element},
                        {"components", reaction.components},
                        {"determined", toText(reaction.determinacy)},
                        {"determined_components", components},
                        {"undetermined", toJson(reaction.undetermined)}});
    }
    return list;
}

Json toJson(const std::vector<mobility::Loop>& loops) {
    Json list = Json::array();
    for (const mobility::Loop& loop : loops) {
        list.push_back({{"joints", loop.joints},
                        {"bodies", loop.bodies},
                        {"through_world", loop.throughWorld},
                        {"gear", loop.gear},
                        {"columns", loop.columns},
                        {"constraint_rows", loop.rows},
                        {"gruebler", loop.gruebler},
                        {"rank", loop.rank},
                        {"mobility", loop.mobility},
                        {"redundant", loop.redundant}});
    }
    return list;
}

const char* toText(mobility::AdviceEnd end) {
    switch (end) {
        case mobility::AdviceEnd::Complete:
            return "complete";
        case mobility::AdviceEnd::TimeUp:
            return "time";
        case mobility::AdviceEnd::Cancelled:
            return "cancelled";
    }
    return "";
}

Json jointCounts(const mobility::Report& report) {
    Json joints;
    joints["total"] = report.joints;
    for (std::size_t i = 0; i < report.jointsByFreedom.size(); ++i) {
        joints["f" + std::to_string(i + 1)] = report.jointsByFreedom[i];
    }
    return joints;
}

Json countsOf(const mobility::Report& report) {
    Json json;
    json["joints_by_freedom"] = jointCounts(report);
    json["gruebler"] = report.gruebler;
    json["constraint_rows"] = report.rows;
    json["rank"] = report.rank;
    json["mobility"] = report.mobility;
    json["redundant"] = report.redundant;
    json["idle"] = report.idle.size();
    return json;
}

}  // namespace

nlohmann::ordered_json toJson(const mobility::Advice& advice) {
    Json json;
    json["verdict"] = mobility::describe(advice);
    json["already_exact"] = advice.alreadyExact;
    json["complete"] = advice.end == mobility::AdviceEnd::Complete;
    json["ended"] = toText(advice.end);
    json["searched_moved_pose"] = advice.searchedMovedPose;
    json["one_sided"] = advice.oneSided;
    json["notes"] = advice.notes;
    json["built"] = countsOf(advice.built);
    json["relaxed_in_file"] = countsOf(advice.fileRelaxed);
    json["proposals"] = Json::array();
    for (const mobility::Proposal& proposal : advice.proposals) {
        Json item;
        item["joints"] = Json::array();
        for (const mobility::JointChange& change : proposal.changes) {
            item["joints"].push_back({{"name", change.element},
                                      {"from", change.from},
                                      {"to", change.to},
                                      {"sides", project::nameOf(change.sides)},
                                      {"relaxed", change.relaxed},
                                      {"changes", change.copies},
                                      {"freed", change.freed},
                                      {"cost", change.cost}});
        }
        item.update(countsOf(proposal.report));
        item["changed"] = proposal.changed;
        item["cost"] = proposal.cost;
        item["margin"] = proposal.margin;
        item["why"] = proposal.why;
        json["proposals"].push_back(std::move(item));
    }
    return json;
}

nlohmann::ordered_json toJson(const mobility::Study& study) {
    Json json = toJson(study.present);
    json["moved"] = toJson(study.moved);
    json["reactions"] = toJson(study.reactions);
    json["loops"] = toJson(study.loops);
    return json;
}

nlohmann::ordered_json toJson(const mobility::Report& report) {
    Json json;
    json["model"] = report.model == mobility::Model::Built ? "built" : "relaxed";
    json["bodies"] = report.bodies;
    json["joints"] = jointCounts(report);
    json["gruebler"] = report.gruebler;
    json["columns"] = report.columns;
    json["constraint_rows"] = report.rows;
    json["rank"] = report.rank;
    json["mobility"] = report.mobility;
    json["redundant"] = report.redundant;
    json["rank_gap"] = numberOrNull(report.rankGap);
    json["verdict"] = mobility::describe(report);
    json["removable_constraints"] = toJson(report.removable);
    Json shares = Json::array();
    for (const mobility::ElementShare& share : mobility::shareByElement(report)) {
        shares.push_back(
            {{"element", share.element}, {"share", share.share}, {"part", share.part}});
    }
    json["self_stress"] = shares;
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
