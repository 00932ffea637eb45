#include "tests/bench/peers/peer.h"

namespace peers {

PeerMaker bulletMaker() {
    return {};
}

}  // namespace peers
