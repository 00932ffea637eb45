#include "tests/bench/peers/peer.h"

namespace peers {

PeerMaker mujocoMaker() {
    return {};
}

}  // namespace peers
