#include "simcore/dynamics/ode_world.h"

#include <cstdarg>
#include <mutex>
#include <stdexcept>

namespace simcore::dynamics {
namespace {

thread_local long messages = 0;

void countMessage(int /*number*/, const char* /*text*/, va_list /*arguments*/) {
    ++messages;
}

void initialiseLibrary() {
    dInitODE2(0);
    if (!dCheckConfiguration("ODE_double_precision")) {
        throw std::runtime_error("the ODE library is not built in double precision");
    }
    dSetMessageHandler(countMessage);
}

/// Per-thread data of ODE, freed when the thread ends.
class ThreadData {
  public:
    ThreadData() { dAllocateODEDataForThread(dAllocateMaskAll); }

    ~ThreadData() { dCleanupODEAllDataForThread(); }

    ThreadData(const ThreadData&) = delete;
    ThreadData& operator=(const ThreadData&) = delete;
};

// Solver settings (docs/engines.md). The compliance makes the joints of hyperstatic mechanisms
// slightly elastic (1.25 N per nm at 2 ms): much stiffer, and round-off alone strains them enough
// to make wheels slide sideways.
constexpr double kCompliance = 4e-7;

}  // namespace

void useOdeOnThisThread() {
    static std::once_flag once;
    std::call_once(once, initialiseLibrary);
    thread_local const ThreadData data;
}

long odeMessagesOnThisThread() {
    return messages;
}

OdeWorld::OdeWorld() {
    useOdeOnThisThread();
    world_ = dWorldCreate();
    threading_ = dThreadingAllocateSelfThreadedImplementation();
    dWorldSetStepThreadingImplementation(world_, dThreadingImplementationGetFunctions(threading_),
                                         threading_);
    contactGroup_ = dJointGroupCreate(0);
    dWorldSetERP(world_, kJointErrorReduction);
    dWorldSetCFM(world_, kCompliance);
    // A sleeping rover would read as one without slip.
    dWorldSetAutoDisableFlag(world_, 0);
    dWorldSetDamping(world_, 0.0, 0.0);
    dWorldSetMaxAngularSpeed(world_, dInfinity);
}

OdeWorld::~OdeWorld() {
    dJointGroupDestroy(contactGroup_);
    dWorldDestroy(world_);
    dThreadingFreeImplementation(threading_);
}

}  // namespace simcore::dynamics
