// The reader of project files and what every opened project goes through: checks, resolving,
// writing, mobility.
#include <cmath>
#include <random>
#include <string>

#include <nlohmann/json.hpp>

#include "simcore/io/project_file.h"
#include "simcore/mobility/mobility.h"
#include "simcore/project/resolve.h"
#include "simcore/run/simulation.h"
#include "tests/fuzz/fuzz.h"

using namespace simcore;
using fuzz::require;

namespace {

// The analysis is cubic in the bodies; larger rovers say nothing new about bad input.
constexpr std::size_t kMaxBodies = 60;

void checkMobility(const mechanism::Mechanism& mechanism) {
    for (const auto model : {mobility::Model::Built, mobility::Model::Relaxed}) {
        const mobility::Report report = mobility::analyse(mechanism, model);
        require(report.gruebler == report.columns - report.rows, "gruebler = columns - rows");
        require(report.mobility == report.columns - report.rank && report.mobility >= 0,
                "mobility = columns - rank >= 0");
        require(report.redundant == report.rows - report.rank && report.redundant >= 0,
                "redundant = rows - rank >= 0");
        mobility::describe(report);
    }
}

void checkMechanism(const project::Project& project, bool sound) {
    const auto mechanism = project::resolve(project);
    require(mechanism || hasCritical(mechanism.problems()), "no mechanism without a reason");
    require(mechanism || !sound, "what passed every check has a mechanism");
    if (!mechanism) {
        return;
    }
    for (const mechanism::Body& body : mechanism->bodies) {
        require(std::isfinite(body.mass) && body.com.allFinite() && body.inertia.allFinite(),
                "a body's numbers are finite");
    }
    if (mechanism->bodies.size() <= kMaxBodies) {
        checkMobility(*mechanism);
    }
}

/// The reader of the clipboard, and pasting into an empty project.
void checkParts(std::string_view text) {
    const auto parts = io::parseParts(text);
    if (!parts) {
        require(hasCritical(parts.problems()), "no refusal without a reason");
        return;
    }
    const auto again = io::parseParts(io::formatParts(*parts));
    require(again && *again == *parts, "parts written are parts read");
    const auto pasted = project::withParts(project::Project{}, *parts);
    require(pasted || hasCritical(pasted.problems()), "no refusal without a reason");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    checkParts(fuzz::textOf(data, size));
    const auto project = io::parseProject(fuzz::textOf(data, size), "input");
    if (!project) {
        require(hasCritical(project.problems()), "no refusal without a reason");
        return 0;
    }
    const std::string written = io::formatProject(*project);
    const auto again = io::parseProject(written, "written");
    require(static_cast<bool>(again), "what was written can be read");
    require(*again == *project, "what was written reads back equal");
    require(io::formatProject(*again) == written, "written again, byte for byte the same");
    const Problems problems = run::checkProject(*project);
    for (const Problem& problem : problems) {
        require(!problem.reason.empty() && !problem.remedy.empty(), "problems say what to do");
    }
    checkMechanism(*project, !hasCritical(problems));
    return 0;
}

#ifdef ROVER_LIBFUZZER

using Json = nlohmann::ordered_json;
using Random = std::minstd_rand;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

std::size_t pick(Random& random, std::size_t count) {
    return random() % count;
}

/// Some node of the tree, deep ones as likely as shallow ones.
Json& pickNode(Json& root, Random& random) {
    Json* at = &root;
    while (at->is_structured() && !at->empty() && pick(random, 8) != 0) {
        auto child = at->begin();
        std::advance(child, static_cast<std::ptrdiff_t>(pick(random, at->size())));
        at = &*child;
    }
    return *at;
}

std::string mutatedText(const std::string& text) {
    std::string changed = text;
    changed.resize(text.size() + 16);
    changed.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(changed.data()), text.size(),
                                    changed.size()));
    return changed;
}

void mutateNode(Json& node, Random& random) {
    static const std::array kNumbers{0.0,  -0.0,  1.0,    -1.0,   1e-300,      1e300,
                                     1e-9, 1e154, 5e-324, 1e-154, 3000000000., 0.5};
    switch (pick(random, 4)) {
        case 0:
            node = kNumbers[pick(random, kNumbers.size())];
            return;
        case 1:
            node = node.is_string() ? Json(mutatedText(node.get<std::string>())) : Json("1");
            return;
        case 2:
            if (node.is_array() && !node.empty()) {
                node.push_back(Json(node[pick(random, node.size())]));
                return;
            }
            node = Json::array();
            return;
        default:
            if (node.is_structured() && !node.empty()) {
                auto child = node.begin();
                std::advance(child, static_cast<std::ptrdiff_t>(pick(random, node.size())));
                node.erase(child);
                return;
            }
            node = Json::object();
    }
}

}  // namespace

/// Half of the mutations change the tree instead of bytes: most changed bytes only break the JSON,
/// and what lies behind its parser would hardly be reached.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
    Random random(seed + 1);
    Json root = Json::parse(fuzz::textOf(data, size), nullptr, false);
    if (root.is_discarded() || pick(random, 2) == 0) {
        return LLVMFuzzerMutate(data, size, maxSize);
    }
    if (pick(random, 3) == 0) {
        const Json copy = pickNode(root, random);
        pickNode(root, random) = copy;
    } else {
        mutateNode(pickNode(root, random), random);
    }
    const std::string text = root.dump(-1, ' ', false, Json::error_handler_t::ignore);
    if (text.size() > maxSize) {
        return LLVMFuzzerMutate(data, size, maxSize);
    }
    std::copy(text.begin(), text.end(), data);
    return text.size();
}

#endif
