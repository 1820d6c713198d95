#include "tunnel/peers.hpp"

namespace carom::tunnel {

Peers fcl_peers()
{
    return {{"fcl_naive", "fcl_advancement"}, {}, "built without FCL (install libfcl-dev, configure and build again)"};
}

}  // namespace carom::tunnel
