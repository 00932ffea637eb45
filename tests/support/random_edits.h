#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>

#include "simcore/base/random.h"
#include "simcore/project/edit.h"
#include "simcore/project/handles.h"

namespace testsupport {

/// Edits by lot, with every function that the editors have. What is refused is no edit.
class RandomEdits {
  public:
    explicit RandomEdits(std::uint64_t seed) : random_(seed) {}

    int below(int count) { return static_cast<int>(random_.next() % static_cast<unsigned>(count)); }

    /// The project with an edit; nothing when the lot is one that cannot be made.
    std::optional<simcore::project::Project> edit(const simcore::project::Project& project) {
        using namespace simcore::project;
        const auto kinds = allElementKinds();
        const ElementKind kind =
            kinds[static_cast<std::size_t>(below(static_cast<int>(kinds.size())))];
        const int count = countOf(project, kind);
        // A rover of hundreds of bodies tests nothing that one of ten does not.
        constexpr int kMany = 12;
        const bool grows = count < kMany;
        const int lot = below(10);
        if (lot == 0) {
            return grows ? taken(added(project, kind)) : std::nullopt;
        }
        if (lot == 1) {
            return numberChanged(project);
        }
        if (lot == 2) {
            return handleDragged(project);
        }
        if (count == 0) {
            return std::nullopt;
        }
        ElementRef element{kind, below(count)};
        if (kind == ElementKind::Body) {
            const int shapes = shapeCountOf(project, element.index);
            if (below(4) == 0 && shapes < kMany) {
                const int shape = below(4);
                return taken(withNewShape(project, element.index, static_cast<ShapeKind>(shape)));
            }
            element.shape = shapes > 0 && below(2) == 0 ? below(shapes) : -1;
        }
        switch (lot) {
            case 3:
                return taken(removed(project, element));
            case 4:
                return taken(renamed(project, element, "name" + std::to_string(below(1000))));
            case 5:
                return grows ? taken(duplicated(project, element)) : std::nullopt;
            case 6:
                return taken(moved(project, element, below(count + 1) - 1));
            case 7:
                return taken(mirrored(project, {element}, below(2) == 0));
            case 8:
                return grows ? taken(split(project, {element})) : std::nullopt;
            default:
                return grows ? taken(withParts(project, partsOf(project, {element}), 0))
                             : std::nullopt;
        }
    }

  private:
    static std::optional<simcore::project::Project> taken(
        const simcore::Result<simcore::project::Project>& result) {
        return result ? std::optional(*result) : std::nullopt;
    }

    std::optional<simcore::project::Project> numberChanged(simcore::project::Project project) {
        int count = 0;
        simcore::project::forEachQuantity(project, [&](simcore::project::Quantity&) { ++count; });
        const int chosen = count == 0 ? -1 : below(count);
        simcore::project::Quantity* quantity = nullptr;
        simcore::project::forEachQuantity(project, [&](simcore::project::Quantity& each) {
            if (--count == chosen) {
                quantity = &each;
            }
        });
        if (quantity == nullptr) {
            return std::nullopt;
        }
        setValue(project, *quantity, random_.uniform(-0.1, 1.0));
        return project;
    }

    std::optional<simcore::project::Project> handleDragged(
        const simcore::project::Project& project) {
        const auto handles = simcore::project::handlesOf(project);
        if (handles.empty()) {
            return std::nullopt;
        }
        simcore::project::DragRequest request;
        request.axes = {below(2) == 0, below(2) == 0, below(2) == 0};
        request.to = {random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0),
                      random_.uniform(0.0, 1.0)};
        request.replace = below(4) == 0;
        const auto result = dragged(
            project, handles[static_cast<std::size_t>(below(static_cast<int>(handles.size())))],
            request);
        return result ? std::optional(result->project) : std::nullopt;
    }

    simcore::Random random_;
};

/// How many steps: of the environment's variable, or `usual`.
inline int stepsFrom(const char* variable, int usual) {
    const char* text = std::getenv(variable);
    return text == nullptr ? usual : std::atoi(text);
}

}  // namespace testsupport
